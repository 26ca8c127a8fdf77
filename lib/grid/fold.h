/* fold.h - cells of a grid that are turned over against a neighbour. */
#ifndef FOLD_H
#define FOLD_H

#include "../base/chart.h"

/* Sets folded[nv][nu] to 1 for each cell, numbered by its node of least (i,j), whose normal makes more than a right angle
 * with that of a cell beside it or of one of its own corners, or is undefined, and to 0 elsewhere: both cells of a pair
 * are folded.  Only cells within `radius` cells of an open side count; pairs across a fold of the chart do not.
 * Returns how many are folded. */
int fold_mark(Chart g, const double *const phi[3], int radius, unsigned char *folded);

#endif
