/* sampler.c - a mapped mesh as a function on its chart. */
#include <stdlib.h>

#include "sampler.h"

int
sampler_init(Sampler *s, const Disk *d, const double *u, const double *v, double T, int surface)
{
	int e = 0, e1 = 0;

	*s = (Sampler){ .surface = surface };
#pragma omp parallel sections
	{
#pragma omp section
		e = locator_init(&s->l, d, u, v, T);
#pragma omp section
		if (surface == SAMPLER_SMOOTH) {
			s->jet = malloc(d->m.nv*sizeof *s->jet);
			s->want = calloc(d->m.nv, 1);
			e1 = !s->jet || !s->want || stars_init(&s->stars, &d->m);
		}
	}
	if (!e && !e1)
		return 0;
	sampler_free(s);
	return SAMPLER_ENOMEM;
}

void
sampler_free(Sampler *s)
{
	locator_free(&s->l);
	stars_free(&s->stars);
	free(s->jet);
	free(s->want);
	s->jet = NULL;
	s->want = NULL;
}

/* The jets at the corners of the triangles that hold the points. */
static void
find_jets(const Sampler *s, int n, const double *x, const double *y)
{
	const Mesh *m = s->l.m;
	int p;

	#pragma omp parallel for schedule(static)
	for (p = 0; p < n; p++) {
		double w[3];
		int k, t = locate(&s->l, x[p], y[p], w);

		for (k = 0; k < 3; k++) {
			unsigned char *want = &s->want[m->tri[3*t + k]], is;

			#pragma omp atomic read
			is = *want;
			if (is)
				continue;
			#pragma omp atomic write
			*want = GRADIENT_WANTED;
		}
	}
	gradient_some(&s->stars, m, s->l.u, s->l.v, s->want, s->jet);
}

static void
sample(const Sampler *s, double x, double y, double phi[3])
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

	if (s->surface == SAMPLER_SMOOTH)
		find_jets(s, g.nu*g.nv, x, y);
	#pragma omp parallel for schedule(static)
	for (p = 0; p < g.nu*g.nv; p++) {
		double at[3];
		int c;

		sample(s, x[p], y[p], at);
		for (c = 0; c < 3; c++)
			phi[c][p] = at[c];
	}
}
