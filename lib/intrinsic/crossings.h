/* crossings.h - where the edges of the mesh cross those of an intrinsic triangulation.
 *
 * Every edge of the mesh that is not an edge of the triangulation crosses some of its edges.
 * Which ones, and in which order, is kept as integers: a flip changes them without any
 * geometry.  Within a triangle the pieces of mesh edges cannot cross each other; so the
 * numbers of crossings on its three sides determine where each piece goes.
 */
#ifndef CROSSINGS_H
#define CROSSINGS_H

#include <stddef.h>

#include "intrinsic.h"

/* Updates the lists for the flip of the edge of side h; call it before the flip.  Returns 0 or INTRINSIC_ENOMEM. */
int crossings_flip(Intrinsic *t, int h);

/* The pieces of mesh edges within a triangle.  They join its sides round the corners, and from at most one corner
 * some go to the opposite side. */
typedef struct Pieces {
	int round[3];           /* the number of pieces round each corner */
	int start[3];           /* the number of those that start at it; 0 at two corners at least */
} Pieces;

Pieces crossings_pieces(const Intrinsic *t, int triangle);

/* The places of all crossings.  Those of edge e are number first[e] .. first[e+1]-1, from its
 * start. */
typedef struct Places {
	size_t *first;          /* [ne+1] */
	double *on_mesh;        /* 0..1 from the start of the mesh edge, as its mesh_side has it */
	double *on_edge;        /* 0..1 from the start of the edge of the triangulation; not falling */
} Places;

/* Unfolds the triangles along each edge of the mesh into the plane.  Returns 0 or INTRINSIC_ENOMEM; p
 * then holds nothing to free. */
int  crossings_places(const Intrinsic *t, Places *p);
void places_free(Places *p);

#endif
