/* pillowgrid.c - nodes, their places on the sphere, and back. */
#include <math.h>
#include <stdlib.h>

#include "../base/pillowplane.h"
#include "pillowgrid.h"

static void
normalise(Spinor Z)
{
	double norm = hypot(cabs(Z[0]), cabs(Z[1]));

	Z[0] /= norm;
	Z[1] /= norm;
}

int
pillowgrid_init(PillowGrid *a, Chart g, const SphereSampler *s)
{
	int n = g.nu*g.nv, p, c;
	PillowPlane plane = pillowplane(g.T);

	*a = (PillowGrid){ g, malloc(n*sizeof *a->at), { malloc(3*(size_t)n*sizeof(double)), NULL, NULL } };
	for (c = 1; c < 3; c++)
		a->phi[c] = a->phi[0] + (size_t)c*n;
	if (a->at && a->phi[0]) {
		#pragma omp parallel for schedule(static)
		for (p = 0; p < n; p++) {
			pillowplane_z(&plane, chart_u(g, p%g.nu), chart_v(g, p/g.nu), a->at[p]);
			normalise(a->at[p]);
		}
		if (!spheresampler_points(s, n, a->at, a->phi))
			return 0;
	}
	pillowgrid_free(a);
	return POLISH_ENOMEM;
}

void
pillowgrid_free(PillowGrid *a)
{
	free(a->at);
	free(a->phi[0]);
	a->at = NULL;
	a->phi[0] = NULL;
}

int
pillowgrid_uv(const PillowGrid *a, int n, Spinor *point, double *u, double *v)
{
	PillowPlane plane = pillowplane(a->g.T);
	int i;

	#pragma omp parallel for schedule(static)
	for (i = 0; i < n; i++)
		pillowplane_uv(&plane, point[i], &u[i], &v[i]);
	return 0;
}
