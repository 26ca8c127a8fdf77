/* stats.h - summary statistics: mean, maximum, median. */
#ifndef STATS_H
#define STATS_H

#include <stddef.h>

double stats_mean(size_t n, const double *x);
double stats_max(size_t n, const double *x);

/* The middle of x in order (the upper one of two); x is sorted in place. */
double stats_median(size_t n, double *x);

#endif
