/* boundarysplit.h - one more vertex on the boundary of a disk. */
#ifndef BOUNDARYSPLIT_H
#define BOUNDARYSPLIT_H

#include "mesh.h"

/* Splits the longest boundary edge at its middle; of equally long ones the first in the loop.  The
 * new vertex is the last one, its number in the file is -1, and its channels are means of the ends.
 * Returns 0 or MESH_ENOMEM; d is then unchanged. */
int boundary_split(Disk *d);

#endif
