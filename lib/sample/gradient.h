/* gradient.h - derivatives of a surface over its chart, at the vertices of its mesh.
 *
 * At vertex i the cubic polynomial in (u,v) that has the value phi_i there is fitted to
 * the vertices around by weighted least squares,
 *
 *   minimise  sum_j w_j^2 |P(u_j,v_j) - phi_j|^2,     P(u_i,v_i) = phi_i,
 *
 * over two rings of neighbours, or more until the points determine all terms of P (at most
 * six rings, 64 points).  The neighbourhood is first scaled to unit variance in all
 * directions, so that neither the unit nor the aspect of the triangles matters; w_j =
 * 1/distance in those coordinates.  The fit is by Householder reflections.  A term that
 * depends on earlier ones at these points (few points, or points in few rows) is left out,
 * the higher degrees first.  For smooth phi the error is O(h^3) in first derivatives and
 * O(h^2) in second ones, also on the boundary; cubics are exact.
 *
 * Limits.  Creases, noise and overlapping triangles must not make an interpolant of these
 * derivatives overshoot.  With e the step in (u,v) from i to another vertex of a triangle
 * at i, d the step in R^3, and L the longest side of that triangle in R^3,
 *
 *   |phi'(e) - d| <= GRADIENT_BEND L,     |phi''(e,e)|/8 <= GRADIENT_BEND L.
 *
 * A fit that exceeds them is cut to degree 2; if that exceeds them too, to degree 1; if that
 * still exceeds them, it is scaled down until it keeps them.  Nothing is cut on
 * the smooth surfaces of mkmesh from 60 vertices on, nor near z -> z^2, the local form of the
 * map where a corner of the rectangle lies on a smooth boundary.  On scans and cortices with
 * their discrete (u,v), up to two vertices in a thousand are cut; on the worst meshes (faces of
 * 2000 vertices, coarse heads) three in a hundred.
 */
#ifndef GRADIENT_H
#define GRADIENT_H

#include "../mesh/mesh.h"

enum { GRADIENT_ENOMEM = -1 };

#define GRADIENT_BEND 1.5

/* First and second partial derivatives of phi at a vertex. */
typedef struct Jet {
	double u[3], v[3], uu[3], uv[3], vv[3];
} Jet;

/* The triangles at vertex i: side[first[i]] .. side[first[i+1]-1], as 3*t + k where i is
 * corner k of t.  Their order depends on (u,v), not on how vertices and triangles are numbered. */
typedef struct Stars {
	int *first, *side;
} Stars;

/* Returns 0, or GRADIENT_ENOMEM with nothing to free. */
int  stars_init(Stars *s, const Mesh *m, const double *u, const double *v);
void stars_free(Stars *s);

/* State of a vertex: a caller sets GRADIENT_WANTED; the fit replaces it by GRADIENT_KNOWN,
 * plus GRADIENT_LOW or GRADIENT_LIMITED or both where they apply. */
enum {
	GRADIENT_WANTED  = 1,
	GRADIENT_KNOWN   = 2,
	GRADIENT_LOW     = 4,   /* the polynomial lacks a term of the nine */
	GRADIENT_LIMITED = 8    /* the polynomial was cut or scaled */
};

/* The derivatives at the vertices in state GRADIENT_WANTED: finite if u, v and phi are finite
 * and at most 1e100 in size; 0 at a vertex without triangles.  Runs in threads, and the result
 * does not depend on their number; time and memory are linear in the mesh.
 *
 * s        in      the triangles at each vertex of m
 * m        in      phi = m->xyz; the mesh need not be a disk
 * u, v     in      [nv]; triangles may be degenerate or turned over in (u,v)
 * state    in/out  [nv]
 * jet      out     [nv], set where state was GRADIENT_WANTED */
void gradient_fit(const Stars *s, const Mesh *m, const double *u, const double *v,
	unsigned char *state, Jet *jet);

#endif
