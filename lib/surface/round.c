/* round.c - the square of the conformal factor of a round surface. */
#include <stdlib.h>

#include "round.h"

int
round2(Chart g, double **r)
{
	size_t n = (size_t)g.nu*g.nv, p;
	double *x, sum = 0;

	*r = NULL;
	if (!g.kind->round)
		return 0;
	x = malloc(n*sizeof *x);
	if (!x)
		return ROUND_ENOMEM;
	g.kind->round(g, x);
	for (p = 0; p < n; p++)
		sum += x[p] *= x[p];
	for (p = 0; p < n; p++)
		x[p] *= n/sum;
	*r = x;
	return 0;
}
