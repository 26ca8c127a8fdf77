/* boundarysplit.h - adds a vertex on the boundary of a disk. */
#ifndef BOUNDARYSPLIT_H
#define BOUNDARYSPLIT_H

#include "mesh.h"

/* Splits the longest boundary edge at its middle; of equally long ones the first in the loop.  The
 * new vertex has the highest number.  Its number in d->file is -1, and its channels are the means
 * of both ends.  Returns 0, or MESH_ENOMEM with d unchanged. */
int boundary_split(Disk *d);

/* 1 if the triangle that boundary_split has split is turned over at the places u, v of its corners, 0
 * if not or if d has no such triangle.  The two triangles that it was split into may both be right
 * then. */
int boundary_split_turned(const Disk *d, const double *u, const double *v);

#endif
