/* bicubic.h - grid fields between their nodes.
 *
 * Piecewise bicubic and C1: along each direction a cubic between neighbouring nodes,
 * with their values and with slopes from differences over five nodes, central inside and
 * one-sided at the ends (fewer nodes where the grid has fewer than five).  So polynomials
 * of degree 3 in u and in v come out exactly, and a smooth field to the fourth order of
 * h and k, up to the border.
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

/* Place (x,y) counted in nodes, brought into 0 .. nu-1 and 0 .. nv-1; nu, nv >= 2. */
Bicubic bicubic_at(int nu, int nv, double x, double y);

/* f, [nv][nu], there. */
double bicubic_value(const Bicubic *b, const double *f);

#endif
