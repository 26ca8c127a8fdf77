/* gridmesh.h - a gridded surface as a triangle mesh. */
#ifndef GRIDMESH_H
#define GRIDMESH_H

#include "../mesh/mesh.h"

/* Two triangles for each cell of a grid, cut along its shorter diagonal, or along the
 * one from (i,j) to (i+1,j+1) when they are equal.  Node (i,j) becomes vertex j*nu + i;
 * the triangles' normals are along phi_u x phi_v, as n is.
 *
 * x y z  in  [nv][nu] each, nu and nv at least 2
 *
 * Returns 0 or MESH_ENOMEM; m then holds nothing to free.  A grid whose triangles int
 * cannot number is MESH_ENOMEM, too. */
int mesh_from_grid(Mesh *m, int nu, int nv, const double *x, const double *y, const double *z);

#endif
