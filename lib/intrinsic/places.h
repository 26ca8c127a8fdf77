/* places.h - where the edges of an intrinsic triangulation cross those of its mesh. */
#ifndef PLACES_H
#define PLACES_H

#include <stddef.h>

#include "intrinsic.h"

/* The places of all crossings.  The crossings on edge e of the triangulation, in order from its
 * start, have the numbers first[e] .. first[e+1]-1. */
typedef struct Places {
	size_t *first;          /* [ne+1] */
	double *on_mesh;        /* [first[ne]] 0..1 along the mesh edge, from mesh_from */
	double *on_edge;        /* [first[ne]] 0..1 along the edge, ascending */
} Places;

/* Computes the places by unfolding the triangles along each edge of the mesh into the plane.  Returns
 * 0, or INTRINSIC_ENOMEM with nothing to free. */
int  places_init(const Intrinsic *t, Places *p);
void places_free(Places *p);

#endif
