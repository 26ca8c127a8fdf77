/* stats.c - summary statistics: mean, maximum, median. */
#include <stdlib.h>

#include "stats.h"

double
stats_mean(size_t n, const double *x)
{
	double sum = 0;
	size_t p;

	for (p = 0; p < n; p++)
		sum += x[p];
	return sum/n;
}

double
stats_max(size_t n, const double *x)
{
	double max = x[0];
	size_t p;

	for (p = 1; p < n; p++)
		max = x[p] > max ? x[p] : max;
	return max;
}

static int
ascending(const void *a, const void *b)
{
	double x = *(const double *)a, y = *(const double *)b;

	return (x > y) - (x < y);
}

double
stats_median(size_t n, double *x)
{
	qsort(x, n, sizeof *x, ascending);
	return x[n/2];
}
