/* embed.h - a disk split until its intrinsic Delaunay triangulation can be embedded in a rectangle
 * (doc/mathematics.md 3.6). */
#ifndef EMBED_H
#define EMBED_H

#include "../intrinsic/edgepoints.h"
#include "../intrinsic/intrinsic.h"
#include "../mesh/subdivision.h"

enum { EMBED_ENOMEM = -1 };

typedef struct Embeddable {
	Subdivision mesh;       /* the disk with points added on its edges */
	Intrinsic   t;          /* of mesh.d, Delaunay */
	int         vertex[4];  /* the corners of the rectangle */
	int         corner[4];  /* the same as indices into the loop of mesh.d */
	double     *key;        /* [mesh.d.m.nv] for intrinsic_delaunay */
} Embeddable;

/* Starts with the disk itself: no points are added, and t is empty until embed is called.  vertex:
 * the corners, as vertex numbers.  Returns 0 or EMBED_ENOMEM; s then holds nothing to free. */
int  embed_init(Embeddable *s, const Disk *d, const int vertex[4]);
void embed_free(Embeddable *s);

/* Makes the triangulation of the mesh, and splits edges that would collapse in a map: loops, edges
 * that share both ends with another edge, and inner edges between vertices of one side.  In the
 * first four rounds, while there are fewer than `most` vertices, feet of perpendiculars are added, too
 * (edgepoints_feet).  Edges that would collapse remain if they are too short to be split
 * (INTRINSIC_SHORTEST), and may remain after 12 rounds.  Returns 0 or EMBED_ENOMEM. */
int  embed(Embeddable *s, int most);

/* Adds points to the mesh; embed must follow, for a new triangulation.  Returns the number of new
 * vertices, or EMBED_ENOMEM. */
int  embed_add(Embeddable *s, const EdgePoints *points);

#endif
