/* gridmesh.h - a gridded surface as a triangle mesh. */
#ifndef GRIDMESH_H
#define GRIDMESH_H

#include "../mesh/mesh.h"

/* Two triangles for each cell of a grid, cut along its shorter diagonal, or along the
 * one from (i,j) to (i+1,j+1) if they are equal; along the longer one where the shorter
 * leaves more triangles without area (../mesh/polygon.h).  Node (i,j) becomes vertex j*nu + i;
 * the normals of the triangles have the direction of n.
 *
 * x y z  in  [nv][nu] each, nu and nv at least 2
 *
 * Returns 0, or MESH_ENOMEM with nothing to free, also if the triangles are too many for int. */
int mesh_from_grid(Mesh *m, int nu, int nv, const double *x, const double *y, const double *z);

/* The two triangles of the cell with lowest node p, in tri.  Returns how many have no area. */
int gridmesh_cell(const Mesh *m, int p, int nu, int tri[6]);

/* Gives area to the faces of a mesh of mesh_from_grid that have none: nodes that coincide with a
 * neighbour, or lie on a line with two of them, move towards the mean of their neighbours along u
 * and v, by 1/1024 of the way, or more if that is too little.  The corners of the grid stay.
 *
 * single   in   coordinates are rounded to float and remain floats; all nodes that then coincide move,
 *               neighbours or not: readers of STL join what coincides
 * left     out  faces that have no area even so, and nodes that coincide in floats: the surface
 *               around is a line or a point, or its cells are smaller than the rounding of
 *               coordinates
 *
 * Returns 0, or MESH_ENOMEM; m is a mesh in both cases. */
int gridmesh_part(Mesh *m, int nu, int nv, int single, int *left);

#endif
