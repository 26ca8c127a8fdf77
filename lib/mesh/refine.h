/* refine.h - refinement of a disk by splitting its triangles; the surface stays the same. */
#ifndef REFINE_H
#define REFINE_H

#include "mesh.h"

/* Split the marked faces ([nf], 1 or 0) into four, and their neighbours as far as a conforming
 * mesh needs it, by longest-edge bisection (Rivara): no angle becomes smaller than half of the
 * smallest before, and obtuse angles are cut.  If marked is NULL, all faces are split into four
 * similar ones.  Old vertices keep number and position.  New ones are midpoints of edges, numbered
 * after the old; their channels are means of both ends.
 *
 * finer  out  a disk of the same surface (its note and err are ""); disk_free it
 *
 * ends   out  [finer->m.nv - d->m.nv] the ends of the edge of each new vertex; free it.  May be NULL
 *
 * Returns 0 or MESH_ENOMEM; finer and ends then hold nothing to free. */
int refine_split(const Disk *d, const unsigned char *marked, Disk *finer, int (**ends)[2]);

#endif
