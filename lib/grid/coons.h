/* coons.h - interpolation of border values into the grid (S. A. Coons 1967). */
#ifndef COONS_H
#define COONS_H

/* The value f at node (i,j).  With u = i/(nu-1), v = j/(nv-1), and d the values on the border:
 *
 *   f = (1-u) d_left(v) + u d_right(v) + (1-v) d_bottom(u) + v d_top(u)
 *     - (1-u)(1-v) d_00 - u (1-v) d_10 - (1-u) v d_01 - u v d_11
 *
 * d  in   [2(nu-1) + 2(nv-1)][3], in the order of border.h
 * f  out  equal to d on the border */
void coons(int nu, int nv, const double *d, int i, int j, double f[3]);

#endif
