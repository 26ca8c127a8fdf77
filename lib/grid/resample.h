/* resample.h - grids of other sizes over the same rectangle. */
#ifndef RESAMPLE_H
#define RESAMPLE_H

#include "../base/chart.h"

enum { RESAMPLE_ENOMEM = -1 };

/* f on the nodes of `from` to e on the nodes of `to`, by cubics through the four nearest
 * nodes in each direction; nodes that are in both keep their values.  A grid whose nodes
 * end before the rectangle does is continued. The last node of `from` is at end[0] <= 1 of
 * the width and end[1] <= 1 of the height. */
int resample_cubic(Chart from, const double end[2], const double *f, Chart to, double *e);

/* f to a coarser grid, each node the mean of its surroundings, weighted by a hat that reaches
 * the next coarse nodes: what is too fine for `to` goes.  Border nodes take the mean along
 * the border. */
int resample_mean(Chart from, const double *f, Chart to, double *e);

#endif
