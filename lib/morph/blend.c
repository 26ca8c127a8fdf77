/* blend.c - linear interpolation of fields. */
#include <string.h>

#include "blend.h"

void
blend(size_t n, double t, const double *a, const double *b, double *f)
{
	size_t p;

	if (t == 0 || t == 1) {                                 /* copies bits, even the sign of 0 */
		memcpy(f, t == 0 ? a : b, n*sizeof *f);
		return;
	}
	for (p = 0; p < n; p++)
		f[p] = (1 - t)*a[p] + t*b[p];                   /* (20)-(22) */
}
