/* clough.h - a C1 interpolant of a surface over its chart: Clough and Tocher's cubic.
 *
 * Each triangle of the (u,v) plane is split at its centroid.  On each of the three parts phi
 * is a cubic, and phi and its first derivatives are continuous within the triangle and over
 * its sides.  At the vertices it has the positions and the first derivatives of the jets; on a
 * side it is the cubic given by those at the two ends.  At the middle of a side its derivative
 * across the side is that of a cubic with the jets at the ends,
 *
 *   phi'(M) = (phi'_i + phi'_j)/2 + (phi''_i - phi''_j)(e)/8,   e from i to j.
 *
 * In the classical element that derivative is linear along the side (the first term only).
 * That element is exact for quadratics only, and H converges linearly at best.  This one is
 * exact for cubics: O(h^4) for phi, O(h^2) for second derivatives.
 *
 * No formula divides by the area of a triangle: one that is degenerate or turned over in
 * (u,v) has an interpolant, too, continuous with those of its neighbours.
 *
 * Limit.  The distance of phi from the flat triangle, at the same barycentric coordinates, is
 * nowhere more than GRADIENT_BEND/3 = 1/2 of the triangle's longest side in R^3.  On the
 * sides this follows from the limits of gradient.h; inside, the derivatives across the sides
 * are limited for it.  A triangle limited in this way is continuous with its neighbours but has no
 * common tangent plane with them.
 */
#ifndef CLOUGH_H
#define CLOUGH_H

#include "gradient.h"

typedef struct Clough {
	const Mesh   *m;
	const double *u, *v;    /* [nv] */
	const Jet    *jet;      /* [nv], of gradient_fit for the same mesh, u and v */
} Clough;

/* phi at barycentric coordinates bary, of sum 1, of triangle t.  Slightly negative coordinates
 * extrapolate the cubic next to the side.  Exact at the vertices.  Returns the number of sides
 * of t across which the derivative was limited, 0 to 3. */
int clough_eval(const Clough *c, int t, const double bary[3], double phi[3]);

#endif
