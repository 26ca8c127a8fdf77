/* sampler.c - a mapped mesh as a function of (u,v) on its chart. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "overlayface.h"
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
			e1 = !s->jet || !s->state || stars_init(&s->stars, &d->m, u, v);
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
	locator_free(&s->under);
	free(s->smooth);
	free(s->face);
	s->smooth = NULL;
	s->face = NULL;
	stars_free(&s->stars);
	free(s->jet);
	free(s->state);
	s->jet = NULL;
	s->state = NULL;
}

/* Sets smooth to 0 at rough vertices and those of triangles that are turned over or flat in (u,v), to 1 at the
 * others. */
static void
mark_unturned(const Locator *l, const unsigned char *rough, double *smooth)
{
	int i, t, k;

	for (i = 0; i < l->m->nv; i++)
		smooth[i] = !(rough && rough[i]);
	for (t = 0; t < l->m->nf; t++)
		if (locate_is_flat(l, t))
			for (k = 0; k < 3; k++)
				smooth[l->m->tri[3*(size_t)t + k]] = 0;
}

int
sampler_overlay(Sampler *s, const Subdivision *o, const double *u, const double *v, const unsigned char *rough)
{
	double *smooth = malloc(s->l.m->nv*sizeof *smooth);

	s->smooth = malloc(o->d.m.nv*sizeof *s->smooth);
	s->face = malloc(o->d.m.nf*sizeof *s->face);
	if (!smooth || !s->smooth || !s->face || overlay_faces(s->l.m, &s->stars, o, s->face)
	    || locator_init(&s->under, &o->d, u, v, s->l.T)) {
		free(smooth);
		return SAMPLER_ENOMEM;
	}
	mark_unturned(&s->l, rough, smooth);
	subdivision_extend(o, 1, smooth, s->smooth);
	free(smooth);
	s->overlay = o;
	return 0;
}

/* A point of the chart.  w are its barycentric coordinates 1 and 2 in triangle t of the mesh, b
 * those in triangle f of the overlay; coordinate 0 is 1 minus their sum. */
typedef struct Place {
	int    t, f;
	double w[2], b[2];
	double smooth;          /* weight of the smooth surface, 0 .. 1; the facets have the rest */
} Place;

/* Interpolates x, given at the vertices of m, linearly in triangle t. */
static double
linear(const Mesh *m, int t, const double w[2], const double *x, int stride)
{
	const int *c = &m->tri[3*(size_t)t];

	return (1 - w[0] - w[1])*x[(size_t)stride*c[0]] + w[0]*x[(size_t)stride*c[1]]
	    + w[1]*x[(size_t)stride*c[2]];
}

static Place
find_place(const Sampler *s, double x, double y)
{
	Place p = { 0, 0, { 0, 0 }, { 0, 0 }, 1 };
	double w[3];

	if (s->overlay) {
		p.f = locate(&s->under, x, y, w);
		p.b[0] = w[1], p.b[1] = w[2];
		p.smooth = linear(&s->overlay->d.m, p.f, p.b, s->smooth, 1);
		if (p.smooth == 0)
			return p;
	}
	if (s->overlay && s->face[p.f] >= 0)
		p.t = locate_from(&s->l, s->face[p.f], x, y, w);
	else
		p.t = locate(&s->l, x, y, w);
	p.w[0] = w[1], p.w[1] = w[2];
	if (s->overlay)
		p.smooth = fmin(p.smooth, linear(s->l.m, p.t, p.w, s->smooth, 1));
	return p;
}

/* The places of n points (x,y), to be freed; NULL if memory runs out. */
static Place *
find_places(const Sampler *s, int n, const double *x, const double *y)
{
	Place *place = malloc(n*sizeof *place);
	int p;

	if (!place)
		return NULL;
	#pragma omp parallel for schedule(static)
	for (p = 0; p < n; p++)
		place[p] = find_place(s, x[p], y[p]);
	return place;
}

/* Marks as GRADIENT_WANTED the corners of the triangles of these places that need a jet and have none
 * yet. */
static void
mark_corners(const Mesh *m, int n, const Place *place, unsigned char *state)
{
	int p;

	#pragma omp parallel for schedule(static)
	for (p = 0; p < n; p++) {
		int k;

		for (k = 0; k < 3 && place[p].smooth > 0; k++) {
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

/* The two surfaces that are sampled: mesh m with its jets, which has the triangles t of Place, and
 * the overlay `under`, which has the triangles f. */
typedef struct Surfaces {
	const Mesh    *m, *under;
	unsigned char *state;
	Jet           *jet;
} Surfaces;

static void
sample_linear(const Mesh *m, int t, const double w[2], double phi[3])
{
	int c;

	for (c = 0; c < 3; c++)
		phi[c] = linear(m, t, w, m->xyz + c, 3);
}

static void
sample(const Sampler *s, const Surfaces *on, const Place *p, double phi[3])
{
	const Clough clough = { on->m, s->l.u, s->l.v, on->jet };
	const double w[3] = { 1 - p->w[0] - p->w[1], p->w[0], p->w[1] };
	double facet[3];
	int c;

	if (s->surface != SAMPLER_SMOOTH) {
		sample_linear(on->m, p->t, p->w, phi);
		return;
	}
	if (p->smooth > 0)
		clough_eval(&clough, p->t, w, phi);
	if (p->smooth == 1)
		return;
	sample_linear(on->under, p->f, p->b, facet);
	for (c = 0; c < 3; c++)
		phi[c] = p->smooth > 0 ? facet[c] + p->smooth*(phi[c] - facet[c]) : facet[c];
}

/* Samples the first `dimensions` coordinates at n places. */
static void
sample_places(const Sampler *s, const Surfaces *on, int n, const Place *place, int dimensions,
	double *const phi[])
{
	int p;

	if (s->surface == SAMPLER_SMOOTH) {
		mark_corners(on->m, n, place, on->state);
		gradient_fit(&s->stars, on->m, s->l.u, s->l.v, on->state, on->jet);
	}
	#pragma omp parallel for schedule(static)
	for (p = 0; p < n; p++) {
		double at[3];
		int c;

		sample(s, on, &place[p], at);
		for (c = 0; c < dimensions; c++)
			phi[c][p] = at[c];
	}
}

int
sampler_points(const Sampler *s, int n, const double *x, const double *y, double *const phi[3])
{
	Place *place = find_places(s, n, x, y);

	if (!place)
		return SAMPLER_ENOMEM;
	sample_places(s, &(Surfaces){ s->l.m, s->under.m, s->state, s->jet }, n, place, 3, phi);
	free(place);
	return 0;
}

/* Sets xyz to the surface (f, a u, a v) over the chart, where f is a scalar and a its range. */
static void
graph(const Sampler *s, const double *f, int stride, double *xyz)
{
	double lo = HUGE_VAL, hi = -HUGE_VAL;
	int i, nv = s->l.m->nv;

	for (i = 0; i < nv; i++, f += stride) {
		lo = fmin(lo, *f);
		hi = fmax(hi, *f);
	}
	for (f -= (size_t)nv*stride, i = 0; i < nv; i++, f += stride, xyz += 3) {
		xyz[0] = *f;
		xyz[1] = (hi - lo)*s->l.u[i];
		xyz[2] = (hi - lo)*s->l.v[i];
	}
}

int
sampler_channel(const Sampler *s, const Channel *c, int n, const double *x, const double *y,
	double *const out[])
{
	Place *place = find_places(s, n, x, y);
	size_t nv = s->l.m->nv, nu = s->overlay ? (size_t)s->overlay->d.m.nv : nv;
	unsigned char *state = malloc(nv);
	Jet *jet = malloc(nv*sizeof *jet);
	Mesh m = *s->l.m, under = s->overlay ? s->overlay->d.m : m;
	int k, e = SAMPLER_ENOMEM;

	m.xyz = malloc(3*nv*sizeof *m.xyz);
	under.xyz = malloc(3*nu*sizeof *under.xyz);
	if (place && state && jet && m.xyz && under.xyz) {
		for (k = 0; k < c->n; k++) {
			memset(state, 0, nv);
			graph(s, c->f + k, c->n, m.xyz);
			if (s->overlay)
				subdivision_extend(s->overlay, 3, m.xyz, under.xyz);
			sample_places(s, &(Surfaces){ &m, &under, state, jet }, n, place, 1, &out[k]);
		}
		e = 0;
	}
	free(place);
	free(state);
	free(jet);
	free(m.xyz);
	free(under.xyz);
	return e;
}
