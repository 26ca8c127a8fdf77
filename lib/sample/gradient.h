/* gradient.h - derivatives of a surface over its chart, at the vertices of its mesh.
 *
 * At vertex i a cubic polynomial P in (u,v) with the value phi_i at the vertex is fitted to the
 * vertices around it by weighted least squares,
 *
 *   minimise  sum_j w_j^2 |P(u_j,v_j) - phi_j|^2,     P(u_i,v_i) = phi_i,
 *
 * over two rings of neighbours.  Rings are added, up to six rings and 64 points, until there are
 * more than 15 points and they determine all terms of P.  The points in (u,v) are first transformed
 * linearly to unit variance in all directions, so that neither the unit nor the aspect ratio of the
 * triangles matters; w_j is 1/distance from vertex i in the new coordinates, at most 1000: nearer
 * neighbours differ by little more than the error of the map.  The fit is by Householder
 * reflections.  A term that is linearly dependent on earlier ones at these points (few points, or
 * points on few lines) is left out, so terms of high degree are the first to go.  For smooth phi the
 * error is O(h^3) in first derivatives and O(h^2) in second ones, also on the boundary; cubics are
 * exact.
 *
 * Limits.  Creases, noise and overlapping triangles must not make an interpolant of these
 * derivatives overshoot.  With e the step in (u,v) from i to another vertex of a triangle
 * at i, d the step in R^3, and L the longest side of that triangle in R^3,
 *
 *   |phi'(e) - d| <= GRADIENT_BEND L,     |phi''(e,e)|/8 <= GRADIENT_BEND L.
 *
 * If the cubic violates these limits, a quadratic polynomial is fitted instead; if the quadratic
 * violates them, a linear one; if the linear one violates them, it is scaled down.  No fit is limited
 * on the smooth surfaces of mkmesh with 60 or more vertices, nor near z -> z^2, the local form of the
 * map where a corner of the rectangle lies on a smooth boundary.  On scans and cortices with the
 * (u,v) of mesh2rect, up to two vertices in a thousand are limited; on the worst meshes (human faces
 * with 2000 vertices, coarse heads) three in a hundred.
 */
#ifndef GRADIENT_H
#define GRADIENT_H

#include "stars.h"

#define GRADIENT_BEND 1.5

/* First and second partial derivatives of phi at a vertex. */
typedef struct Jet {
	double u[3], v[3], uu[3], uv[3], vv[3];
} Jet;

/* Flags of the state of a vertex.  The caller sets GRADIENT_WANTED; gradient_fit replaces it by
 * GRADIENT_KNOWN, and adds GRADIENT_LOW and GRADIENT_LIMITED where they apply. */
enum {
	GRADIENT_WANTED  = 1,
	GRADIENT_KNOWN   = 2,
	GRADIENT_LOW     = 4,   /* some of the nine terms of the polynomial were left out */
	GRADIENT_LIMITED = 8    /* the degree was reduced, or the fit scaled down */
};

/* Computes the derivatives at the vertices in state GRADIENT_WANTED.  They are finite if u, v and
 * phi are finite and at most 1e100 in absolute value, and 0 at a vertex without triangles.  The
 * result does not depend on the number of threads.  Time and memory are linear in the size of the
 * mesh.
 *
 * s        in      the triangles at each vertex of m
 * m        in      phi = m->xyz; the mesh need not be a disk
 * u, v     in      [nv]; triangles may be degenerate or turned over in (u,v)
 * state    in/out  [nv]
 * jet      out     [nv], set where state was GRADIENT_WANTED */
void gradient_fit(const Stars *s, const Mesh *m, const double *u, const double *v,
	unsigned char *state, Jet *jet);

#endif
