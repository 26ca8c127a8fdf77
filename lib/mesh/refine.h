/* refine.h - refinement of a disk by splitting its triangles; the surface stays the same. */
#ifndef REFINE_H
#define REFINE_H

#include "mesh.h"

/* Splits the marked faces into four, and their neighbours as far as a conforming mesh needs it, by
 * longest-edge bisection (Rivara): no angle becomes smaller than half of the smallest before, and
 * obtuse angles are cut.  Old vertices keep number and position.  New ones are midpoints of edges,
 * numbered after the old; their channels are means of both ends.
 *
 * marked  in   [nf] 1 or 0; or NULL: all faces are split into four similar ones
 * key     in   [nv] tells sides of equal length apart (longestside.h); or NULL
 * finer   out  a disk of the same surface (its note and err are ""); disk_free it
 * ends    out  [finer->m.nv - d->m.nv] the ends of the edge of each new vertex; free it.  May be NULL
 *
 * Returns 0, or MESH_ENOMEM with nothing to free in finer and ends. */
int refine_split(const Disk *d, const unsigned char *marked, const double *key, Disk *finer,
	int (**ends)[2]);

#endif
