/* boundarysplit.h - adds a vertex on the boundary of a disk. */
#ifndef BOUNDARYSPLIT_H
#define BOUNDARYSPLIT_H

#include "mesh.h"

/* Splits the longest boundary edge at its middle; of equally long ones the first in the loop.  The
 * new vertex has the highest number.  Its number in d->file is -1, and its channels are the means
 * of both ends.  Returns 0, or MESH_ENOMEM with d unchanged. */
int boundary_split(Disk *d);

#endif
