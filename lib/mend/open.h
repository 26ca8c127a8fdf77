/* open.h - closed surfaces are cut open along a path.  Private to lib/mend. */
#ifndef OPEN_H
#define OPEN_H

#include "sheet.h"

/* Cuts every closed component along a shortest path of edges: from the vertex nearest to `at` to the
 * vertex farthest from it along the surface; or, if at is NULL, between two vertices far from one
 * another.  A cut from end to end leaves the map of the surface no part far from the boundary; the map
 * of a surface with a small opening is hopeless.  The vertices within a path become two, the second
 * of each at the end.  *length: of all paths together.  Returns 0, or MESH_ENOMEM. */
int open_all(Sheet *s, const double *at, double *length);

#endif
