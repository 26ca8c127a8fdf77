/* gridloss.h - what a grid does not hold of the mesh that it samples. */
#ifndef GRIDLOSS_H
#define GRIDLOSS_H

#include "../base/chart.h"
#include "../mesh/mesh.h"

typedef struct GridLoss {
	double area;            /* of the mesh */
	double kept;            /* area of the grid, as mesh_from_grid splits it, over that of the mesh */
	double farthest;        /* the largest distance of a vertex from the surface of the grid, over
	                         * the square root of area */
	int    vertex;          /* the vertex that far away */
} GridLoss;

/* Compares the grid phi, each [g.nv][g.nu], with the mesh m.
 *
 * u, v     in   [m->nv] places of the vertices in the chart of g: how near the grid is there bounds
 *               the distance, and spares most searches.  Wrong places cost time only
 *
 * Returns 0 or MESH_ENOMEM.  The same for any number of threads. */
int gridloss(const Mesh *m, const double *u, const double *v, Chart g, double *const phi[3],
	GridLoss *loss);

/* The area of the grid alone.  Returns 0 or MESH_ENOMEM. */
int gridloss_area(Chart g, double *const phi[3], double *area);

#endif
