/* splitting.h - splits triangles of a disk at new vertices. */
#ifndef SPLITTING_H
#define SPLITTING_H

#include "mesh.h"

/* The splitting of a disk at points of its edges and triangles.  An edge is split at one point
 * after the other; the part with the points that remain is known by one of its sides. */
typedef struct Splitting {
	Disk *d;
	unsigned char *inner;   /* [3*nf] of Subdivision */
	int  *line;             /* [3*nf] the number of the next point on this side, or -1 */
	int  *side;             /* [points] the side that has the point now */
	int  *after;            /* [nv] the next vertex of the boundary, of those on it */
} Splitting;

/* Splits the edge of side h at vertex m.  Returns the side of its second half. */
int  splitting_edge(const Splitting *s, int h, int m);

/* Splits triangle f at vertex m within it into (a,b,m), which keeps its number, (b,c,m) and (c,a,m). */
void splitting_face(const Splitting *s, int f, int m);

/* Writes the boundary loop of the disk from `after`, from its first vertex on. */
void splitting_write_loop(const Splitting *s);

#endif
