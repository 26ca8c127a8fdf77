/* adapt.h - the conformal map of a disk, with adaptive splitting of triangles
 * (doc/mathematics.md 3.3). */
#ifndef ADAPT_H
#define ADAPT_H

#include "../mesh/subdivision.h"
#include "../sparse/spd.h"

/* With u, v1, T and the certificate of rectmap.h, and v = T v1, the Dirichlet energies satisfy
 * E(u) + T^2 E(v1) = 2 T (1 + certificate), and the image has area T.  So the certificate is a sum
 * over triangles,
 *
 *   T*certificate = sum (|grad u|^2 + |grad v|^2) A/2 - (area of the image),
 *
 * with A the area of a triangle.  Each term is >= 0, and 0 only if its triangle is mapped
 * conformally.  The triangles with the largest terms are split.
 *
 * In the end all triangles are split, and quadratic elements use the midpoints of their sides.
 * The error of linear elements is O(h^2), but it is rough from vertex to vertex, so H, which needs
 * second derivatives, does not converge to second order.  With quadratic elements (u,v) is
 * smooth. */
typedef struct AdaptOptions {
	double tolerance;       /* largest certificate: the triangles with the largest terms are
	                         * split until the certificate is at most this.  If < 1, the
	                         * triangles at the corners are split three times before */
	int    split;           /* how often every triangle is then split into four */
	int    most;            /* both kinds of splitting stop at about this many vertices */
} AdaptOptions;

typedef struct AdaptMap {
	Subdivision mesh;       /* the triangulation of the last solve */
	int     corner[4];      /* the corners: indices into the loop of mesh.d */
	double *u, *v, T, certificate;
	int     rounds;         /* of splitting */
	int     quadratic;      /* 1 if the last solve was with quadratic elements */
} AdaptMap;

/* This method fails on the mesh: a triangle is turned over or flat in (u,v) after the last solve,
 * the matrix is not positive definite, or the tolerance needs too many vertices.  Use
 * intrinsic_map. */
enum { ADAPT_HARD = -20 };

/* vertex: the corners, as vertex numbers.  Returns 0, or ADAPT_HARD, SPD_ENOMEM, SPD_ELARGE; if not
 * 0, a holds nothing to free. */
int adapt_map(const Disk *d, const int vertex[4], const AdaptOptions *options, AdaptMap *a,
	SpdReport *report);

void adapt_free(AdaptMap *a);

#endif
