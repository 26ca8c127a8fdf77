/* inverse.h - the inverse of a map of a grid onto itself. */
#ifndef INVERSE_H
#define INVERSE_H

#include "carry.h"

enum { INVERSE_ENOMEM = -1 };

/* For each node p = (i,j) of the grid, the point (x[p], y[p]), in grid steps, that the shift moves to
 * it: x + du(x,y) = i, y + dv(x,y) = j, where du and dv are interpolated by bicubic.h.  Where
 * fixed-point iteration does not contract, as near cells that are folded or much too large for the
 * surface, they are interpolated linearly on the quarters of the cells instead; of several points the
 * one nearest to the node is taken.  du and dv are odd across
 * a fold (chart.h); the quarters are those of the cells within the grid.
 *
 * x, y  out  [nv][nu]
 *
 * Returns 0 or INVERSE_ENOMEM. */
int  shift_inverse(Chart g, const Shift *s, double *x, double *y);

#endif
