/* adapt.h - the conformal map of a disk, with adaptive splitting of facets
 * (doc/mathematics.md 3.3). */
#ifndef ADAPT_H
#define ADAPT_H

#include "../mesh/subdivision.h"
#include "../sparse/spd.h"

/* With v = T v1 the energies of a map satisfy E(u) + T^2 E(v1) = 2 T (1 + certificate), and
 * the image has area T.  So the certificate is a sum over triangles,
 *
 *   T certificate = sum (|grad u|^2 + |grad v|^2) A/2 - (area of the image),
 *
 * in which each term is >= 0, and 0 only if the triangle is mapped conformally.  The triangles
 * with the largest terms are split.
 *
 * In the end all triangles are split, and quadratic elements use the midpoints of their sides.
 * The error of linear elements is O(h^2) but jumps from vertex to vertex, so H does not
 * converge to second order.  With quadratic elements (u,v) is smooth. */
typedef struct AdaptOptions {
	double tolerance;       /* of the certificate; if < 1, the facets at the corners are
	                         * split three times, then those with the largest terms until
	                         * the certificate is no larger than this */
	int    split;           /* number of splits of every facet into four after that */
	int    most;            /* both stop at about this many vertices */
} AdaptOptions;

typedef struct AdaptMap {
	Subdivision mesh;       /* the triangulation of the last solve */
	int     corner[4];      /* indices into its loop */
	double *u, *v, T, certificate;
	int     rounds;         /* of splitting done */
	int     quadratic;      /* 1 if the last solve was with quadratic elements */
} AdaptMap;

/* The mesh is not for this method: a triangle of the last solve is turned over or flat in (u,v), or the
 * tolerance needs too many vertices.  intrinsic_map does better. */
enum { ADAPT_HARD = -20 };

/* vertex: the corners, as vertex numbers.  Returns 0, or ADAPT_HARD, SPD_ENOMEM, SPD_EINDEFINITE,
 * SPD_ELARGE; if not 0, a holds nothing to free. */
int adapt_map(const Disk *d, const int vertex[4], const AdaptOptions *options, AdaptMap *a,
	SpdReport *report);

void adapt_free(AdaptMap *a);

#endif
