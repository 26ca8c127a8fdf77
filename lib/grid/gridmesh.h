/* gridmesh.h - a gridded surface as a triangle mesh. */
#ifndef GRIDMESH_H
#define GRIDMESH_H

#include "../base/chart.h"
#include "../mesh/mesh.h"

/* Sets m to two triangles for each cell of a grid, in the order of chart.h.  A cell is cut along its
 * shorter diagonal or, if both are equally long, along the one from its first corner.  It is cut along
 * the longer one if this leaves fewer triangles without area (../mesh/polygon.h).  Node (i,j) becomes vertex j*nu + i; the
 * normals of the triangles have the direction of phi_u x phi_v.
 *
 * phi  in  [nv][nu] each, nu and nv at least 2
 *
 * Returns 0; or MESH_ENOMEM, also if there are too many triangles for int, with nothing to free. */
int mesh_from_grid(Mesh *m, Chart g, const double *const phi[3]);

/* Sets tri to the vertices of the two triangles of cell number n of g.  Returns how many of the two
 * have no area. */
int gridmesh_cell(const Mesh *m, Chart g, int n, int tri[6]);

/* Moves nodes of a mesh of mesh_from_grid so that faces without area get area.  In each round the
 * nodes of the cells of these faces move towards the mean of their neighbours along u and v: by
 * 1/1024 of the way in the first round, by twice as much in each further one, and at most all the
 * way.  There are at most 24 rounds.  The corners of a rectangle stay.
 *
 * single   in   1: coordinates are rounded to float, and stay floats.  All nodes that then coincide
 *               move, not only neighbours, because readers of STL weld vertices that coincide
 * left     out  number of faces that still have no area, plus, if single, of nodes that still
 *               coincide: the surface there is a line or a point, or its cells are smaller than the
 *               rounding error of the coordinates
 *
 * Returns 0 or MESH_ENOMEM; m remains a complete mesh in both cases. */
int gridmesh_part(Mesh *m, Chart g, int single, int *left);

#endif
