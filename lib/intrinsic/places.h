/* places.h - the places of the crossings of an intrinsic triangulation and its mesh. */
#ifndef PLACES_H
#define PLACES_H

#include <stddef.h>

#include "intrinsic.h"

/* The places of all crossings.  Those on edge e of the triangulation have the numbers
 * first[e] .. first[e+1]-1, from its start. */
typedef struct Places {
	size_t *first;          /* [ne+1] */
	double *on_mesh;        /* 0..1 from the start of the mesh edge, as its mesh_side has it */
	double *on_edge;        /* 0..1 from the start of the edge of the triangulation; ascending */
} Places;

/* Unfolds the triangles along each edge of the mesh into the plane.  Returns 0 or INTRINSIC_ENOMEM; p
 * then holds nothing to free. */
int  places_init(const Intrinsic *t, Places *p);
void places_free(Places *p);

#endif
