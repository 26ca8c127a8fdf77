/* bicubic.h - interpolation of grid fields between their nodes.
 *
 * The interpolant is piecewise bicubic and C1.  In each direction, between two neighbouring nodes,
 * it is the cubic with the values and slopes of these nodes.  The slopes are differences over five
 * nodes (over all nodes if there are fewer), central inside and beside joined sides (chart.h), and
 * one-sided near open ones.  With at least four nodes in each direction, polynomials of degree up to 3
 * in u and in v are reproduced exactly.  For a smooth field the error is of fourth order in h and k, up
 * to the border.
 */
#ifndef BICUBIC_H
#define BICUBIC_H

#include "../base/chart.h"

/* Weights along one direction. */
typedef struct BicubicSpan {
	int    first, n;        /* w[k] belongs to node first + k, 0 <= k < n, which may lie beyond a
	                         * joined side */
	double w[6];
} BicubicSpan;

/* The weights of one place, for any field on that grid. */
typedef struct Bicubic {
	Chart       g;
	BicubicSpan u, v;
} Bicubic;

/* The weights at (x,y).  x and y are in grid steps (node (i,j) is at (i,j)), and are clamped to the
 * nodes of open sides; beyond joined sides they may lie by up to a step.  At least 2 nodes along an
 * axis with open sides, 6 along one with a joined side. */
Bicubic bicubic_at(Chart g, double x, double y);

/* The value of the field f, [nv][nu], at the place of b; for bicubic_odd, f changes its sign where
 * u and v are reversed (chart.h). */
double bicubic_value(const Bicubic *b, const double *f);
double bicubic_odd(const Bicubic *b, const double *f);

#endif
