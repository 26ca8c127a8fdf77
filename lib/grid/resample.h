/* resample.h - converts fields between grids of different sizes over one rectangle. */
#ifndef RESAMPLE_H
#define RESAMPLE_H

#include "../base/chart.h"

enum { RESAMPLE_ENOMEM = -1 };

/* Interpolates f, on the nodes of `from`, to e, on the nodes of `to`, by cubics through the four
 * nearest nodes in each direction; at nodes of both grids the value stays the same.  The last node
 * of `from` lies at the shares end[0] of the width and end[1] of the height, both <= 1; beyond it f
 * is extrapolated. */
int resample_cubic(Chart from, const double end[2], const double *f, Chart to, double *e);

/* Averages f to a coarser grid.  Each node of `to` gets a weighted mean of f: along each direction
 * the weight is a hat function that is 0 at the neighbouring nodes of `to`.  This damps waves too
 * short for `to`.  Nodes on the border get the mean along the border. */
int resample_mean(Chart from, const double *f, Chart to, double *e);

#endif
