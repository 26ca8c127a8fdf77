/* sampler.c - a mapped mesh as a function on its chart. */
#include <stdlib.h>

#include "sampler.h"

int
sampler_init(Sampler *s, const Mesh *m, const double *u, const double *v, double T, int surface)
{
	*s = (Sampler){ .surface = surface };
	if (locator_init(&s->l, m, u, v, T))
		return SAMPLER_ENOMEM;
	if (surface == SAMPLER_FACETS)
		return 0;
	s->jet = malloc(m->nv*sizeof *s->jet);
	if (!s->jet || gradient_fit(m, u, v, s->jet, NULL)) {
		sampler_free(s);
		return SAMPLER_ENOMEM;
	}
	return 0;
}

void
sampler_free(Sampler *s)
{
	locator_free(&s->l);
	free(s->jet);
	s->jet = NULL;
}

void
sampler_at(const Sampler *s, double x, double y, double phi[3])
{
	const Mesh *m = s->l.m;
	const Clough clough = { m, s->l.u, s->l.v, s->jet };
	double w[3];
	int t = locate(&s->l, x, y, w), c;
	const int *v = &m->tri[3*t];

	if (s->surface == SAMPLER_SMOOTH) {
		clough_eval(&clough, t, w, phi);
		return;
	}
	for (c = 0; c < 3; c++)
		phi[c] = w[0]*m->xyz[3*v[0]+c] + w[1]*m->xyz[3*v[1]+c] + w[2]*m->xyz[3*v[2]+c];
}

void
sampler_grid(const Sampler *s, Chart g, const double *x, const double *y, double *const phi[3])
{
	int p;

	#pragma omp parallel for schedule(static)
	for (p = 0; p < g.nu*g.nv; p++) {
		double at[3];
		int c;

		sampler_at(s, x[p], y[p], at);
		for (c = 0; c < 3; c++)
			phi[c][p] = at[c];
	}
}
