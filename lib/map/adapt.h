/* adapt.h - the conformal map of a disk, its facets split where the map errs most. */
#ifndef ADAPT_H
#define ADAPT_H

#include "../mesh/mesh.h"
#include "../sparse/spd.h"

/* With v = T v1 the energies of a map say E(u) + T^2 E(v1) = 2 T (1 + certificate), and
 * the image has area T: so the certificate is a sum over triangles,
 *
 *   T certificate = sum (|grad u|^2 + |grad v|^2) A/2 - (area of the image),
 *
 * each term >= 0 and 0 only where the triangle is mapped conformally: it says which
 * triangles to split.
 *
 * Splitting all of them at last gives the midpoints of their sides to quadratic elements,
 * which make (u,v) smooth: with linear ones every vertex errs by O(h^2) in its own way, which
 * costs H its second order. */
typedef struct AdaptOptions {
	double tolerance;       /* below 1: split the facets at the corners three times, then
	                         * those with the largest terms until this is met.. */
	int    split;           /* ..then every facet into four, so often.. */
	int    most;            /* ..neither beyond about so many vertices */
} AdaptOptions;

typedef struct AdaptMap {
	Disk    d;              /* the triangulation solved on last; its first vertices are
	                         * those of the disk given */
	int     corner[4];      /* in its loop */
	double *u, *v, T, certificate;
	int     rounds;         /* of splitting */
	int     quadratic;      /* the elements of the last solve */
} AdaptMap;

/* vertex: the corners, as vertex numbers.  Returns 0, or SPD_ENOMEM, SPD_EINDEFINITE,
 * SPD_ELARGE; a then holds nothing to free. */
int adapt_map(const Disk *d, const int vertex[4], const AdaptOptions *options, AdaptMap *a,
	SpdReport *report);

void adapt_free(AdaptMap *a);

#endif
