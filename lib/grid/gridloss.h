/* gridloss.h - how far a mesh is from the grid that samples it. */
#ifndef GRIDLOSS_H
#define GRIDLOSS_H

#include "../base/chart.h"
#include "../mesh/mesh.h"

typedef struct GridLoss {
	double area;            /* of the mesh */
	double kept;            /* area of the triangles of mesh_from_grid / area of the mesh */
	double farthest;        /* the largest distance of a vertex of the mesh from the
	                         * triangles of mesh_from_grid, divided by sqrt(area) */
	int    vertex;          /* the vertex at that distance */
} GridLoss;

/* Compares the grid phi, each [g.nv][g.nu], with the mesh m.
 *
 * u, v     in   [m->nv] places of the vertices in the chart of g.  The distance from the cell at
 *               such a place is an upper bound, which makes most searches unnecessary.  Wrong
 *               places cost time, but do not change the result
 *
 * Returns 0 or MESH_ENOMEM.  The result is the same for any number of threads. */
int gridloss(const Mesh *m, const double *u, const double *v, Chart g, double *const phi[3],
	GridLoss *loss);

/* The area of the grid alone.  Returns 0 or MESH_ENOMEM. */
int gridloss_area(Chart g, double *const phi[3], double *area);

#endif
