/* bicubic.h - interpolation of grid fields between their nodes.
 *
 * The interpolant is piecewise bicubic and C1.  In each direction, between two neighbouring nodes,
 * it is the cubic with the values and slopes of these nodes.  The slopes are differences over five
 * nodes (over all nodes if there are fewer), central inside and one-sided near the ends.  With at
 * least four nodes in each direction, polynomials of degree up to 3 in u and in v are reproduced
 * exactly.  For a smooth field the error is of fourth order in h and k, up to the border.
 */
#ifndef BICUBIC_H
#define BICUBIC_H

/* Weights along one direction. */
typedef struct BicubicSpan {
	int    first, n;        /* w[k] belongs to node first + k, 0 <= k < n */
	double w[6];
} BicubicSpan;

/* The weights of one place, for any field on a grid of that size. */
typedef struct Bicubic {
	int         nu;
	BicubicSpan u, v;
} Bicubic;

/* The weights at (x,y).  x and y are in grid steps (node (i,j) is at (i,j)), and are clamped to
 * 0 .. nu-1 and 0 .. nv-1.  nu, nv >= 2. */
Bicubic bicubic_at(int nu, int nv, double x, double y);

/* The value of the field f, [nv][nu], at the place of b. */
double bicubic_value(const Bicubic *b, const double *f);

#endif
