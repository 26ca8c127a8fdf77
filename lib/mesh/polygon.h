/* polygon.h - splits polygons of a soup into triangles.  For lib/ only. */
#ifndef POLYGON_H
#define POLYGON_H

#include "mesh.h"

/* Split every face of s into triangles of its own corners, in the order of the faces.  Triangles
 * are kept.  Quads are split by the diagonal whose worse triangle is better.  Larger polygons are
 * split by ear clipping in their average plane.  *tri is malloc'd, [*ntri][3].
 *
 * Returns 0, MESH_ENOMEM, or MESH_EFACE with the face in err: it has fewer than 3 or more than
 * 10000 corners, a corner twice, or triangles without area (at most 1e-14 of the longest edge
 * squared). */
int polygon_split(const Soup *s, int **tri, int *ntri, char err[MESH_ERRLEN]);

/* The same, but faces with such a fault are left out: their number in *out, the first in err.
 * Returns 0 or MESH_ENOMEM. */
int polygon_split_some(const Soup *s, int **tri, int *ntri, int *out, char err[MESH_ERRLEN]);

/* Whether the triangle a b c has area in the sense of polygon_split: more than 1e-14 of its longest
 * edge squared. */
int polygon_has_area(const double *a, const double *b, const double *c);

#endif
