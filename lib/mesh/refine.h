/* refine.h - refinement of a disk by splitting its triangles; the surface stays the same. */
#ifndef REFINE_H
#define REFINE_H

#include "mesh.h"

/* Split the marked faces ([nf], 1 or 0) into four, and their neighbours as far as a conforming mesh
 * needs it, by longest-edge bisection (Rivara): no angle becomes smaller than half of the smallest
 * before, and obtuse ones are cut.  New vertices are midpoints of edges
 * and numbered after the old, which keep number and place; their channels are means of the ends.  With marked NULL, all faces are
 * split into four similar ones.
 *
 * finer  out  a disk of the same surface (its note and err are ""); disk_free it
 *
 * Returns 0 or MESH_ENOMEM; finer then holds nothing to free. */
int refine_split(const Disk *d, const unsigned char *marked, Disk *finer);

#endif
