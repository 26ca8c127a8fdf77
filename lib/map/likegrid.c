/* likegrid.c - bicubic on the chart, difference quotients on the sphere. */
#include <stdlib.h>

#include "../grid/bicubic.h"
#include "../grid/gridmesh.h"
#include "likegrid.h"
#include "pillowshift.h"

static const double REACH = 0.1;        /* of the difference quotients, in steps of the grid */
static const double LEAST = 1e-13;      /* and at least so far on the sphere */

static int
points_of(LikeGrid *a, Chart g, const double *const phi[3], int n)
{
	Spinor *at = malloc((size_t)g.nu*g.nv*sizeof *at);
	Mesh m;
	int e = at && !mesh_from_grid(&m, g, phi) ? 0 : LIKEPOINTS_ENOMEM;

	if (!e) {
		pillowshift_nodes(g, at);
		e = likepoints_init(&a->points, &m, at, n);
		mesh_free(&m);
	}
	free(at);
	return e;
}

int
likegrid_init(LikeGrid *a, Chart g, const double *const phi[3], int n)
{
	size_t nodes = (size_t)g.nu*g.nv, p;
	int e = points_of(a, g, phi, n), c;

	if (e)
		return e;
	a->g = g;
	a->plane = pillowplane(g.T);
	a->phi[0] = malloc(3*nodes*sizeof(double));
	if (!a->phi[0]) {
		likegrid_free(a);
		return LIKEPOINTS_ENOMEM;
	}
	for (c = 0; c < 3; c++)
		for (a->phi[c] = a->phi[0] + c*nodes, p = 0; p < nodes; p++)
			a->phi[c][p] = (phi[c][p] - a->points.mean[c])/a->points.radius;
	return 0;
}

void
likegrid_free(LikeGrid *a)
{
	likepoints_free(&a->points);
	free(a->phi[0]);
	a->phi[0] = NULL;
}

static void
point_at(const LikeGrid *a, double u, double v, double x[3])
{
	Bicubic at = bicubic_at(a->g, u/chart_h(a->g) - 0.5, v/chart_k(a->g) - 0.5);
	int c;

	for (c = 0; c < 3; c++)
		x[c] = bicubic_value(&at, a->phi[c]);
}

void
likegrid_point(const LikeGrid *a, const Spinor w, double x[3])
{
	double u, v;

	pillowplane_uv(&a->plane, w, &u, &v);
	point_at(a, u, v, x);
}

void
likegrid_slopes(const LikeGrid *a, const Spinor w, double slope[2][3])
{
	double u, v, reach, plus[3], minus[3];
	Spinor to;
	int k, c;

	pillowplane_uv(&a->plane, w, &u, &v);
	reach = fmax(REACH*chart_h(a->g)*pillowplane_round(&a->plane, u, v)/2, LEAST);
	for (k = 0; k < 2; k++) {
		moebius_point(w, k ? CMPLX(0, reach) : reach, to);
		likegrid_point(a, to, plus);
		moebius_point(w, k ? CMPLX(0, -reach) : -reach, to);
		likegrid_point(a, to, minus);
		for (c = 0; c < 3; c++)
			slope[k][c] = (plus[c] - minus[c])/(2*reach);
	}
}
