/* weld.h - vertices of the boundary that lie at one place become one.  Private to lib/mend. */
#ifndef WELD_H
#define WELD_H

#include "sheet.h"

/* Finds the vertices on the boundary that are within `distance` of one another, 0: at equal positions.
 * A vertex is on the boundary if it has an edge of one face.  Pairs are joined transitively; each
 * group is named by its lowest vertex.
 *
 * to  out  [nv] the name of each vertex
 *
 * Returns the number of vertices that are not named by themselves, or MESH_ENOMEM. */
int weld_boundary(const Sheet *s, double distance, int *to);

/* The least distance above `distance` of two vertices on the boundary that share no edge, looked for
 * up to `most`; -1 if there is none, or no memory to look. */
double weld_nearest(const Sheet *s, double distance, double most);

#endif
