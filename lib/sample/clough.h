/* clough.h - a C1 interpolant of a surface over its chart: Clough and Tocher's cubic.
 *
 * Each triangle of the (u,v) plane is split at its centroid.  On each of the three parts phi
 * is a cubic, and phi and its first derivatives are continuous within the triangle and across
 * its sides.  At a vertex, phi is the position of the vertex and has the first derivatives of its
 * jet; on a side, phi is the cubic given by the positions and first derivatives at the two ends.
 * At the middle M of a side, the derivative across the side is that of a cubic that has the
 * first and second derivatives of the jets at both ends,
 *
 *   phi'(M) = (phi'_i + phi'_j)/2 + (phi''_i - phi''_j)(e)/8,   e from i to j.
 *
 * In the classical element that derivative is linear along the side (the first term only).
 * That element is exact for quadratics only, and H converges linearly at best.  This one is
 * exact for cubics: O(h^4) for phi, O(h^2) for second derivatives.
 *
 * No formula divides by the area of a triangle.  So a triangle that is degenerate or turned over in
 * (u,v) has an interpolant, too, which is continuous with those of its neighbours.
 *
 * Limit.  The distance of phi from the flat triangle, at the same barycentric coordinates, is
 * nowhere more than GRADIENT_BEND/3 = 1/2 of the triangle's longest side in R^3.  On the
 * sides this follows from the limits of gradient.h; inside, it is achieved by limiting the
 * derivatives across the sides.  Across a side where this was done, phi is still continuous, but the
 * two triangles have no common tangent plane.
 */
#ifndef CLOUGH_H
#define CLOUGH_H

#include "gradient.h"

typedef struct Clough {
	const Mesh   *m;
	const double *u, *v;    /* [nv] */
	const Jet    *jet;      /* [nv], of gradient_fit for the same mesh, u and v */
} Clough;

/* Evaluates phi in triangle t at the barycentric coordinates bary, whose sum is 1.  If one is
 * slightly negative, the cubic at that side is extrapolated.  Exact at the vertices.  Returns the
 * number of sides of t across which the derivative was limited, 0 to 3. */
int clough_eval(const Clough *c, int t, const double bary[3], double phi[3]);

#endif
