/* weld.h - groups of vertices of the boundary that lie at one place.  Private to lib/mend. */
#ifndef WELD_H
#define WELD_H

#include "sheet.h"

/* Finds the vertices on the boundary that are within `distance` of one another, 0: at equal positions.
 * A vertex is on the boundary if it has an edge of one face.  Pairs are joined transitively; each
 * group is named by its lowest vertex.
 *
 * to  out  [nv] the name of each vertex
 *
 * Returns the number of vertices that have the name of another, or MESH_ENOMEM. */
int weld_boundary(const Sheet *s, double distance, int *to);

/* Sets *least to the least distance above `distance` and up to `most` between two vertices on the boundary
 * that share no face, or to -1 if there is none.  Returns 0 or MESH_ENOMEM. */
int weld_nearest(const Sheet *s, double distance, double most, double *least);

#endif
