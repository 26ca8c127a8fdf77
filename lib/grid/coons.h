/* coons.h - interpolation of border values into the grid. */
#ifndef COONS_H
#define COONS_H

#include "../base/chart.h"

/* The value f at node (i,j) for the values d on the border.  On the rectangle, with u = i/(nu-1) and
 * v = j/(nv-1) (S. A. Coons 1967):
 *
 *   f = (1-u) d_left(v) + u d_right(v) + (1-v) d_bottom(u) + v d_top(u)
 *     - (1-u)(1-v) d_00 - u (1-v) d_10 - (1-u) v d_01 - u v d_11
 *
 * On the sock, with the mean m of d:  f = m + (v/T)^2 (d(u) - m), which is smooth across the fold.
 *
 * d  in   [border_count(g)][3], in the order of border.h
 * f  out  equal to d on the border */
void coons(Chart g, const double *d, int i, int j, double f[3]);

#endif
