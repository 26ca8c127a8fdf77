/* gridloss.c - how far a mesh is from the grid that samples it. */
#include <math.h>
#include <stdlib.h>

#include "gridloss.h"
#include "gridmesh.h"
#include "gridtree.h"

static int
limit(double i, int n)
{
	return i > 0 ? i < n - 1 ? (int)i : n - 1 : 0;
}

/* The number of the cell, of those in a row side by side, that contains or is next to (u,v). */
static int
cell_of(Chart g, double u, double v)
{
	int across = g.kind->joined[0][1] ? g.nu : g.nu - 1;
	double i = floor(u/chart_h(g) - 0.5*g.kind->joined[0][0]);

	if (i < 0 && g.kind->joined[0][0])
		i = across - 1;
	return limit(floor(v/chart_k(g) - 0.5*g.kind->joined[1][0]), g.nv - 1)*across + limit(i, across);
}

/* Sets d2 to the squared distance of each vertex from the cell at its (u,v), an upper bound of its
 * squared distance from the grid.  Returns the vertex with the largest bound. */
static int
bound(const GridTree *t, const Mesh *m, const double *u, const double *v, Chart g, double *d2)
{
	int p, most = 0;

	#pragma omp parallel for schedule(static)
	for (p = 0; p < m->nv; p++)
		d2[p] = gridtree_cell2(t, cell_of(g, u[p], v[p]), m->xyz + 3*(size_t)p);
	for (p = 1; p < m->nv; p++)
		most = d2[p] > d2[most] ? p : most;
	return most;
}

/* Sets loss->vertex, and loss->farthest as a length.  d2 are the bounds, `most` is the vertex with the
 * largest one.  Its true distance is a lower bound of the result, so only vertices with upper bounds
 * above it need a search. */
static void
find_farthest(const GridTree *t, const Mesh *m, double *d2, int most, GridLoss *loss)
{
	const double least = gridtree_distance2(t, m->xyz + 3*(size_t)most, d2[most]);
	int p;

	#pragma omp parallel for schedule(dynamic, 64)
	for (p = 0; p < m->nv; p++)
		if (d2[p] > least)
			d2[p] = gridtree_distance2(t, m->xyz + 3*(size_t)p, d2[p]);
	for (most = 0, p = 1; p < m->nv; p++)
		most = d2[p] > d2[most] ? p : most;
	loss->vertex = most;
	loss->farthest = sqrt(d2[most]);
}

int
gridloss(const Mesh *m, const double *u, const double *v, Chart g, double *const phi[3],
	GridLoss *loss)
{
	double *d2 = malloc(m->nv*sizeof *d2);
	Mesh grid = { 0, 0, NULL, NULL };
	GridTree t = { .levels = 0 };
	int e = d2 ? mesh_from_grid(&grid, g, (const double *const *)phi) : MESH_ENOMEM;

	if (!e && !(e = gridtree_init(&t, &grid, g))) {
		loss->area = mesh_area(m);
		loss->kept = mesh_area(&grid)/loss->area;
		find_farthest(&t, m, d2, bound(&t, m, u, v, g, d2), loss);
		loss->farthest /= sqrt(loss->area);
	}
	gridtree_free(&t);
	mesh_free(&grid);
	free(d2);
	return e;
}

int
gridloss_area(Chart g, double *const phi[3], double *area)
{
	Mesh grid;
	int e = mesh_from_grid(&grid, g, (const double *const *)phi);

	if (!e) {
		*area = mesh_area(&grid);
		mesh_free(&grid);
	}
	return e;
}
