/* splitting.h - splits triangles of a disk at new vertices. */
#ifndef SPLITTING_H
#define SPLITTING_H

#include "mesh.h"

/* The splitting of a disk at points of its edges and triangles.  The points of an edge are inserted
 * one by one.  line and side tell which side contains the points that are not inserted yet. */
typedef struct Splitting {
	Disk *d;
	unsigned char *inner;   /* [3*nf] that of Subdivision, or NULL */
	int  *line;             /* [3*nf] the number of the next point on this side, or -1 */
	int  *side;             /* [points] the side that has the point now */
	int  *after;            /* [nv] the next boundary vertex after a boundary vertex */
} Splitting;

/* Splits the edge of side h at vertex m.  Returns the side of its second half. */
int  splitting_edge(const Splitting *s, int h, int m);

/* Splits triangle f at vertex m within it into (a,b,m), which keeps its number, (b,c,m) and
 * (c,a,m). */
void splitting_face(const Splitting *s, int f, int m);

/* Rewrites the boundary loop of the disk by following `after` from its first vertex. */
void splitting_write_loop(const Splitting *s);

#endif
