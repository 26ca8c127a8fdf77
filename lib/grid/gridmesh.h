/* gridmesh.h - a gridded surface as a triangle mesh. */
#ifndef GRIDMESH_H
#define GRIDMESH_H

#include "../mesh/mesh.h"

/* Two triangles for each cell of a grid, cut along its shorter diagonal, or along the
 * one from (i,j) to (i+1,j+1) if they are equal.  Node (i,j) becomes vertex j*nu + i;
 * the normals of the triangles have the direction of n.
 *
 * x y z  in  [nv][nu] each, nu and nv at least 2
 *
 * Returns 0, or MESH_ENOMEM with nothing to free, also if the triangles are too many for int. */
int mesh_from_grid(Mesh *m, int nu, int nv, const double *x, const double *y, const double *z);

#endif
