/* blend.c - linear interpolation of fields. */
#include "blend.h"

void
blend(size_t n, double t, const double *a, const double *b, double *f)
{
	size_t p;

	for (p = 0; p < n; p++)
		f[p] = (1 - t)*a[p] + t*b[p];                   /* (20)-(22) */
}
