/* resample.h - converts fields between grids of different sizes on one chart. */
#ifndef RESAMPLE_H
#define RESAMPLE_H

#include "../base/chart.h"

enum { RESAMPLE_ENOMEM = -1 };

/* Interpolates f from the nodes of `from` to the nodes of `to`, by cubics through the four nearest
 * nodes in each direction.  At a node of both grids the value stays the same.  The last column of
 * `from` lies at the fraction end[0] of the width of `to`, its last row at the fraction end[1] of
 * the height, both at most 1; beyond them f is extrapolated.  Along an axis with a joined side (chart.h)
 * end is 1.
 *
 * f   in   [from.nv][from.nu]
 * e   out  [to.nv][to.nu]
 *
 * Returns 0 or RESAMPLE_ENOMEM. */
int resample_cubic(Chart from, const double end[2], const double *f, Chart to, double *e);

/* Averages f to a coarser grid.  Each node of `to` gets a weighted mean of f: along each direction
 * the weight is a hat function that is 0 at the neighbouring nodes of `to`.  This damps waves that
 * are too short for `to`.  A node on an open side gets a mean of nodes of that
 * side only.  Arrays and return values as for resample_cubic. */
int resample_mean(Chart from, const double *f, Chart to, double *e);

#endif
