/* worst.c - the largest terms of a sum. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "worst.h"

static const double SHARE = 0.7;        /* the triangles to split have this share of the sum
                                         * of all terms */
static const double EQUAL = 1e-6;       /* relative difference of two terms that differ by rounding
                                         * only */

static int
falling(const void *a, const void *b)
{
	double x = *(const double *)a, y = *(const double *)b;

	return x < y ? 1 : x > y ? -1 : 0;
}

double
worst_term(const int c[3], const double *u, const double *v, double gaa, double gab, double gbb,
	double area)
{
	double ua = u[c[1]] - u[c[0]], ub = u[c[2]] - u[c[0]];
	double va = v[c[1]] - v[c[0]], vb = v[c[2]] - v[c[0]];
	double energy = (ub*ub + vb*vb)*gaa - 2*(ua*ub + va*vb)*gab + (ua*ua + va*va)*gbb;

	return energy/(8*area) - (ua*vb - ub*va)/2;
}

double
worst_terms(const double *term, int nf, int most, double *sorted)
{
	double all = 0, sum = 0;
	int k;

	memcpy(sorted, term, nf*sizeof *sorted);
	qsort(sorted, nf, sizeof *sorted, falling);
	for (k = 0; k < nf; k++)
		all += sorted[k];
	for (k = 0; k < nf && k < most && sum < SHARE*all; k++)
		sum += sorted[k];
	return k > 0 && all > 0 ? sorted[k-1]*(1 - EQUAL) : HUGE_VAL;
}
