/* resample.h - fields between grids of different sizes over the same rectangle. */
#ifndef RESAMPLE_H
#define RESAMPLE_H

#include "../base/chart.h"

enum { RESAMPLE_ENOMEM = -1 };

/* Interpolates f, on the nodes of `from`, to e, on the nodes of `to`, by cubics through the four
 * nearest nodes in each direction; nodes that are in both keep their values.  The last node of
 * `from` is at end[0] <= 1 of the width and end[1] <= 1 of the height; beyond it f is
 * extrapolated. */
int resample_cubic(Chart from, const double end[2], const double *f, Chart to, double *e);

/* Averages f to a coarser grid: each node gets the mean of its surroundings, weighted by a hat that
 * reaches the next coarse nodes, to damp waves too short for `to`.  Border nodes get the mean
 * along the border. */
int resample_mean(Chart from, const double *f, Chart to, double *e);

#endif
