/* boundarysplit.h - adds a vertex on the boundary of a disk. */
#ifndef BOUNDARYSPLIT_H
#define BOUNDARYSPLIT_H

#include "mesh.h"

/* Splits the longest boundary edge at its middle; of equally long ones the first in the loop.  The
 * new vertex has the highest number, -1 in d->file, and the means of both ends as its channels.
 * Returns 0 or MESH_ENOMEM; d is then unchanged. */
int boundary_split(Disk *d);

#endif
