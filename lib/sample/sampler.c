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

/* Where a point lies: barycentric coordinates 1 and 2 in triangle t. */
typedef struct Place {
	int    t;
	double w[2];
} Place;

/* The places of the points; their triangles' corners want jets. */
static void
find_places(const Sampler *s, int n, const double *x, const double *y, Place *place)
{
	const Mesh *m = s->l.m;
	int p;

	#pragma omp parallel for schedule(static)
	for (p = 0; p < n; p++) {
		double w[3];
		int k, t = locate(&s->l, x[p], y[p], w);

		place[p] = (Place){ t, { w[1], w[2] } };
		for (k = 0; s->want && k < 3; k++) {
			unsigned char *want = &s->want[m->tri[3*t + k]], is;

			#pragma omp atomic read
			is = *want;
			if (is)
				continue;
			#pragma omp atomic write
			*want = GRADIENT_WANTED;
		}
	}
}

static void
sample(const Sampler *s, const Place *p, double phi[3])
{
	const Mesh *m = s->l.m;
	const Clough clough = { m, s->l.u, s->l.v, s->jet };
	const double w[3] = { 1 - p->w[0] - p->w[1], p->w[0], p->w[1] };
	const int *v = &m->tri[3*p->t];
	int c;

	if (s->surface == SAMPLER_SMOOTH) {
		clough_eval(&clough, p->t, w, phi);
		return;
	}
	for (c = 0; c < 3; c++)
		phi[c] = w[0]*m->xyz[3*v[0]+c] + w[1]*m->xyz[3*v[1]+c] + w[2]*m->xyz[3*v[2]+c];
}

int
sampler_grid(const Sampler *s, Chart g, const double *x, const double *y, double *const phi[3])
{
	int p, n = g.nu*g.nv;
	Place *place = malloc(n*sizeof *place);

	if (!place)
		return SAMPLER_ENOMEM;
	find_places(s, n, x, y, place);
	if (s->surface == SAMPLER_SMOOTH)
		gradient_some(&s->stars, s->l.m, s->l.u, s->l.v, s->want, s->jet);
	#pragma omp parallel for schedule(static)
	for (p = 0; p < n; p++) {
		double at[3];
		int c;

		sample(s, &place[p], at);
		for (c = 0; c < 3; c++)
			phi[c][p] = at[c];
	}
	free(place);
	return 0;
}
