/* traversal.h - a disk numbered by its connectivity alone. */
#ifndef TRAVERSAL_H
#define TRAVERSAL_H

#include "mesh.h"

/* A disk with its faces and vertices numbered in the order in which a breadth-first search over the
 * faces reaches them.  The search begins at one side of the boundary, so the numbers, and the corner
 * with which each face begins, depend on the connectivity and this side only, not on the numbers
 * before. */
typedef struct Traversal {
	Disk d;                 /* m, twin, loop and nb only; the loop begins with vertex 0 */
	int *number;            /* [d.m.nv] the number in d of each vertex of the given disk */
} Traversal;

/* Numbers the disk `given`.
 *
 * start  in   index into the loop of `given`: the first vertex; the search begins at the boundary
 *             side that starts there
 *
 * Returns 0, or MESH_ENOMEM with nothing in t to free. */
int  traversal_init(Traversal *t, const Disk *given, int start);
void traversal_free(Traversal *t);

#endif
