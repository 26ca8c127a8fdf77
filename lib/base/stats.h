/* stats.h - summary statistics: mean, maximum, median. */
#ifndef STATS_H
#define STATS_H

#include <stddef.h>

/* n must be positive. */
double stats_mean(size_t n, const double *x);
double stats_max(size_t n, const double *x);

/* The median; for even n, the larger of the two middle values.  Sorts x in place. */
double stats_median(size_t n, double *x);

#endif
