/* gradient.h - derivatives of a surface over its chart, at the vertices of its mesh.
 *
 * At vertex i the cubic polynomial in (u,v) that has the value phi_i there is fitted to
 * the vertices around by weighted least squares,
 *
 *   minimise  sum_j w_j^2 |P(u_j,v_j) - phi_j|^2,     P(u_i,v_i) = phi_i,
 *
 * over two rings of neighbours, or more until there are enough points that no term of P
 * depends on the others (at most six rings, 64 points).  The neighbourhood is first
 * brought to unit variance in all directions, so that neither a unit nor the aspect of
 * the triangles matters; w_j = 1/distance, in those coordinates.  The fit is by
 * Householder reflections.  A term that the points cannot tell from earlier ones (few
 * points, or in few rows) is left out, the higher degrees first.  For smooth phi first
 * derivatives carry an O(h^3) error, second ones O(h^2), also on the boundary; cubics are
 * exact.
 *
 * Limits.  Creases, noise and overlapping triangles must not make an interpolant of these
 * derivatives shoot over.  With e the step in (u,v) from i to another vertex of a triangle
 * at i, d the step in R^3, and L the longest side of that triangle in R^3,
 *
 *   |phi'(e) - d| <= GRADIENT_BEND L,     |phi''(e,e)|/8 <= GRADIENT_BEND L.
 *
 * Where that fails the fit is cut to its second degree, else its first, else that is
 * scaled down until it holds.  Nothing is cut on the smooth surfaces of mkmesh from 60
 * vertices on, nor at z -> z^2, which the map of a smooth boundary is at a corner of the
 * rectangle; of the vertices of scans and cortices with their discrete (u,v), none to two
 * in a thousand, of the worst (faces of 2000 vertices, coarse heads) three in a hundred.
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

typedef struct GradientReport {
	int low;                /* vertices whose polynomial lacks a term of the nine */
	int limited;            /* vertices whose polynomial was cut or scaled */
} GradientReport;

/* The triangles at vertex i: side[first[i]] .. side[first[i+1]-1], as 3*t + k where i is
 * corner k of t. */
typedef struct Stars {
	int *first, *side;
} Stars;

/* Returns 0 or GRADIENT_ENOMEM, nothing to free then. */
int  stars_init(Stars *s, const Mesh *m);
void stars_free(Stars *s);

/* The derivatives at all vertices, finite for finite u, v and phi up to 1e100 in size; 0 at
 * a vertex of no triangle.  Threads, and the result does not depend on their number; time
 * and memory linear in the mesh.
 *
 * m        in   phi = m->xyz; the mesh need not be a disk
 * u, v     in   [nv]; triangles may be degenerate or turned over in (u,v)
 * jet      out  [nv]
 * report   out  may be NULL
 *
 * Returns 0 or GRADIENT_ENOMEM. */
int gradient_fit(const Mesh *m, const double *u, const double *v, Jet *jet, GradientReport *report);

enum { GRADIENT_WANTED = 1, GRADIENT_KNOWN = 2 };

/* The same at those vertices of which want[i] says so; it then says that they are known. */
void gradient_some(const Stars *s, const Mesh *m, const double *u, const double *v,
	unsigned char *want, Jet *jet);

#endif
