/* sampler.c - a mapped mesh as a function of (u,v) on its chart. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

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
			s->state = calloc(d->m.nv, 1);
			e1 = !s->jet || !s->state || stars_init(&s->stars, &d->m);
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
	free(s->state);
	s->jet = NULL;
	s->state = NULL;
}

/* A point of the chart as barycentric coordinates 1 and 2 in triangle t. */
typedef struct Place {
	int    t;
	double w[2];
} Place;

/* The places of n points (x,y), to be freed; NULL without memory. */
static Place *
find_places(const Sampler *s, int n, const double *x, const double *y)
{
	Place *place = malloc(n*sizeof *place);
	int p;

	if (!place)
		return NULL;
	#pragma omp parallel for schedule(static)
	for (p = 0; p < n; p++) {
		double w[3];
		int t = locate(&s->l, x[p], y[p], w);

		place[p] = (Place){ t, { w[1], w[2] } };
	}
	return place;
}

/* Marks those corners of the triangles of the places that have no jet yet. */
static void
mark_corners(const Mesh *m, int n, const Place *place, unsigned char *state)
{
	int p;

	#pragma omp parallel for schedule(static)
	for (p = 0; p < n; p++) {
		int k;

		for (k = 0; k < 3; k++) {
			unsigned char *here = &state[m->tri[3*place[p].t + k]], is;

			#pragma omp atomic read
			is = *here;
			if (is)
				continue;
			#pragma omp atomic write
			*here = GRADIENT_WANTED;
		}
	}
}

static void
sample(const Sampler *s, const Mesh *m, const Jet *jet, const Place *p, double phi[3])
{
	const Clough clough = { m, s->l.u, s->l.v, jet };
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

/* The first `dimensions` coordinates of mesh m at n places; state and jet are those of m. */
static void
sample_places(const Sampler *s, const Mesh *m, unsigned char *state, Jet *jet, int n, const Place *place,
	int dimensions, double *const phi[])
{
	int p;

	if (s->surface == SAMPLER_SMOOTH) {
		mark_corners(m, n, place, state);
		gradient_fit(&s->stars, m, s->l.u, s->l.v, state, jet);
	}
	#pragma omp parallel for schedule(static)
	for (p = 0; p < n; p++) {
		double at[3];
		int c;

		sample(s, m, jet, &place[p], at);
		for (c = 0; c < dimensions; c++)
			phi[c][p] = at[c];
	}
}

int
sampler_grid(const Sampler *s, Chart g, const double *x, const double *y, double *const phi[3])
{
	Place *place = find_places(s, g.nu*g.nv, x, y);

	if (!place)
		return SAMPLER_ENOMEM;
	sample_places(s, s->l.m, s->state, s->jet, g.nu*g.nv, place, 3, phi);
	free(place);
	return 0;
}

/* Number k of a channel over the chart as a surface: (f, a u, a v), a the range of f. */
static void
graph(const Sampler *s, const Channel *c, int k, double *xyz)
{
	const double *f = c->f + k;
	double lo = HUGE_VAL, hi = -HUGE_VAL;
	int i, nv = s->l.m->nv;

	for (i = 0; i < nv; i++) {
		lo = fmin(lo, f[(size_t)c->n*i]);
		hi = fmax(hi, f[(size_t)c->n*i]);
	}
	for (i = 0; i < nv; i++, xyz += 3) {
		xyz[0] = f[(size_t)c->n*i];
		xyz[1] = (hi - lo)*s->l.u[i];
		xyz[2] = (hi - lo)*s->l.v[i];
	}
}

int
sampler_channel(const Sampler *s, const Channel *c, Chart g, const double *x, const double *y,
	double *const out[])
{
	Place *place = find_places(s, g.nu*g.nv, x, y);
	size_t nv = s->l.m->nv;
	unsigned char *state = malloc(nv);
	Jet *jet = malloc(nv*sizeof *jet);
	Mesh m = *s->l.m;
	int k, e = SAMPLER_ENOMEM;

	m.xyz = malloc(3*nv*sizeof *m.xyz);
	if (place && state && jet && m.xyz) {
		for (k = 0; k < c->n; k++) {
			memset(state, 0, nv);
			graph(s, c, k, m.xyz);
			sample_places(s, &m, state, jet, g.nu*g.nv, place, 1, &out[k]);
		}
		e = 0;
	}
	free(place);
	free(state);
	free(jet);
	free(m.xyz);
	return e;
}
