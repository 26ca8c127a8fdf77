/* bicubic.h - interpolation of grid fields between their nodes.
 *
 * Piecewise bicubic and C1: along each direction a cubic between neighbouring nodes, with
 * their values and with slopes from differences over five nodes, central inside and one-sided
 * at the ends (over all nodes if the grid has fewer than five).  Polynomials of degree 3 in u
 * and in v are exact; for a smooth field the error is of fourth order in h and k, up to the
 * border.
 */
#ifndef BICUBIC_H
#define BICUBIC_H

/* The weights of one place, for any field of that size. */
typedef struct BicubicSpan {
	int    first, n;        /* nodes first .. first+n-1 of one direction */
	double w[6];
} BicubicSpan;

typedef struct Bicubic {
	int         nu;
	BicubicSpan u, v;
} Bicubic;

/* The weights at (x,y), counted in nodes and clamped to 0 .. nu-1 and 0 .. nv-1; nu, nv >= 2. */
Bicubic bicubic_at(int nu, int nv, double x, double y);

/* The value of f, [nv][nu], at that place. */
double bicubic_value(const Bicubic *b, const double *f);

#endif
