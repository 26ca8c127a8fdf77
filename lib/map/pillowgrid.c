/* pillowgrid.c - nodes, their places on the sphere, and back. */
#include <math.h>
#include <stdlib.h>

#include "pillowgrid.h"
#include "pillowshift.h"

int
pillowgrid_alloc(PillowGrid *a, Chart g)
{
	size_t n = (size_t)g.nu*g.nv;
	int c;

	*a = (PillowGrid){ g, malloc(n*sizeof *a->at), { malloc(3*n*sizeof(double)), NULL, NULL } };
	if (!a->at || !a->phi[0]) {
		pillowgrid_free(a);
		return POLISH_ENOMEM;
	}
	for (c = 1; c < 3; c++)
		a->phi[c] = a->phi[0] + c*n;
	return 0;
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
pillowgrid_init(PillowGrid *a, Chart g, const SphereSampler *s)
{
	if (pillowgrid_alloc(a, g))
		return POLISH_ENOMEM;
	pillowshift_nodes(g, a->at);
	if (!spheresampler_points(s, g.nu*g.nv, a->at, a->phi))
		return 0;
	pillowgrid_free(a);
	return POLISH_ENOMEM;
}

int
pillowgrid_uv(const PillowGrid *a, int n, Spinor *point, double *u, double *v)
{
	PillowShift s;
	int i;

	if (pillowshift_init(&s, a->g, a->at))
		return POLISH_ENOMEM;
	#pragma omp parallel for schedule(dynamic, 256)
	for (i = 0; i < n; i++) {
		Spinor from;

		pillowshift_from(&s, point[i], from);
		pillowplane_uv(&s.plane, from, &u[i], &v[i]);
	}
	pillowshift_free(&s);
	return 0;
}
