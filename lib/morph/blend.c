/* blend.c - weighted sums of fields. */
#include <string.h>

#include "blend.h"

int
blend_single(int count, const double *w)
{
	int k, single = -1;

	for (k = 0; k < count; k++) {
		if (w[k] == 0)
			continue;
		if (w[k] != 1 || single >= 0)
			return -1;
		single = k;
	}
	return single;
}

void
blend(size_t n, int count, const double *w, const double *const *of, double *f)
{
	int single = blend_single(count, w), k;
	double sum;
	size_t p;

	if (single >= 0) {                                      /* copies bits, even the sign of 0 */
		memcpy(f, of[single], n*sizeof *f);
		return;
	}
	for (p = 0; p < n; p++) {
		sum = w[0]*of[0][p];
		for (k = 1; k < count; k++)
			sum += w[k]*of[k][p];                   /* (20)-(22) */
		f[p] = sum;
	}
}
