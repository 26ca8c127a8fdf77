/* vertexkey.h - numbers of vertices that depend on the shape alone. */
#ifndef VERTEXKEY_H
#define VERTEXKEY_H

#include "../mesh/mesh.h"

/* A number at each vertex that does not depend on how the vertices are numbered, nor on where the
 * surface lies and in which units: a sum of sines of its distances to the four corners.  The waves
 * are short, so the number is far from linear even among near vertices.  The corners have slightly
 * different weights, so that on symmetric surfaces the numbers differ, too.  The number decides
 * between edges of equal length and between Delaunay triangulations.
 *
 * vertex  in  the corners, as vertex numbers
 *
 * Returns [m->nv], to be freed; NULL if there is no memory. */
double *vertex_keys(const Mesh *m, const int vertex[4]);

/* The index, 0 to 3, of the corner with the largest mean distance from the vertices; the first of
 * several that are equal up to rounding. */
int     vertex_first(const Mesh *m, const int vertex[4]);

#endif
