/* pocket.h - the parts of a disk behind inner edges between two vertices of one side. */
#ifndef POCKET_H
#define POCKET_H

#include "../mesh/mesh.h"

enum { POCKET_ENOMEM = -1 };

/* An inner edge between two vertices of one side of the rectangle lies on that side.  The part of
 * the disk behind it, its pocket, lies between the edge and the side, so it has no area, or some of
 * its triangles are turned over.  pocket_sides adds the bit of the side to all vertices of its pockets.
 *
 * corner  in      indices into the boundary loop (corners.h)
 * side    in/out  [d->m.nv] of harmonic_sides
 *
 * Returns 0 or POCKET_ENOMEM. */
int pocket_sides(const Disk *d, const int corner[4], unsigned char *side);

/* The same on a sock, whose boundary is one side.  The pocket is the part of the disk that has less of the
 * boundary, by u of place [d->m.nv][2]. */
int pocket_round(const Disk *d, const double *place, unsigned char *side);

#endif
