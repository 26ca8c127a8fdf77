/* conformal.c - the conformal grid of a disk. */
#include <stdlib.h>
#include <string.h>

#include "../intrinsic/overlay.h"
#include "conformal.h"
#include "intrinsicmap.h"
#include "rectmap.h"
#include "untangle.h"

/* Mean modulus of the Beltrami coefficient below which a grid from linear elements is not
 * polished: the error of H then comes from the roughness of (u,v), and polishing gains nothing.
 * With quadratic elements it comes from what the polish leaves, so those are always polished. */
static const double ENOUGH = 2e-4;

/* Samples a map on the grid and polishes it; the polish moves the vertices of d in the chart with it.
 * u, v: the map at the vertices of d, which come first. */
static int
sample_and_polish(const Sampler *s, const Disk *d, const int corner[4], const double *u,
	const double *v, Chart g, double enough, const ConformalOptions *options, Conformal *c)
{
	g.T = s->l.T;
	if (grid_init(&c->grid, g, s))
		return SPD_ENOMEM;
	memcpy(c->u, u, d->m.nv*sizeof *c->u);
	memcpy(c->v, v, d->m.nv*sizeof *c->v);
	if (polish(s, &c->grid, options->polish, enough, d->m.nv, c->u, c->v, &c->polished))
		return SPD_ENOMEM;
	return untangle(d, corner, c->u, c->v, &c->turned) ? SPD_ENOMEM : 0;
}

/* A map of d, solved on a finer mesh. */
typedef struct Solved {
	const Subdivision *mesh;
	const double      *u, *v;       /* [mesh->d.m.nv] */
	double             T, enough;
} Solved;

/* Samples the surface.  A smooth one is sampled on d, but near triangles of d that are turned over
 * or flat on the facets of the finer mesh. */
static int
sample(const Disk *d, const int corner[4], const Solved *m, Chart g, const ConformalOptions *options,
	Conformal *c)
{
	int smooth = options->surface == SAMPLER_SMOOTH, e;
	Sampler s;

	if (sampler_init(&s, smooth ? d : &m->mesh->d, m->u, m->v, m->T, options->surface))
		return SPD_ENOMEM;
	e = smooth && c->overlaid && sampler_overlay(&s, m->mesh, m->u, m->v) ? SPD_ENOMEM
	    : sample_and_polish(&s, d, corner, m->u, m->v, g, m->enough, options, c);
	sampler_free(&s);
	return e;
}

static int
sample_adapted(const Disk *d, const int corner[4], const AdaptMap *a, Chart g,
	const ConformalOptions *options, Conformal *c)
{
	Solved m = { &a->mesh, a->u, a->v, a->T, a->quadratic ? 0 : ENOUGH };

	c->certificate = a->certificate;
	c->vertices = a->mesh.d.m.nv;
	c->overlaid = rectmap_flipped(&d->m, a->u, a->v) + rectmap_flat(&d->m, a->u, a->v);
	return sample(d, corner, &m, g, options, c);
}

static int
sample_intrinsic(const Disk *d, const int corner[4], IntrinsicMap *a, Chart g,
	const ConformalOptions *options, Conformal *c)
{
	Solved m = { &a->s.mesh, NULL, NULL, a->T, a->quadratic ? 0 : ENOUGH };

	c->certificate = a->certificate;
	c->vertices = a->s.t.nv;
	c->solved_turned = a->turned;
	c->overlaid = rectmap_flipped(&d->m, a->u, a->v) + rectmap_flat(&d->m, a->u, a->v);
	if ((c->overlaid || options->surface == SAMPLER_FACETS) && overlay(&a->s.t, &a->s.mesh, &a->u, &a->v))
		return SPD_ENOMEM;
	m.u = a->u, m.v = a->v;
	return sample(d, corner, &m, g, options, c);
}

/* Whether the tolerance was not reached, although vertices could be added. */
static int
missed(const Disk *d, const AdaptMap *a, const AdaptOptions *o)
{
	return o->tolerance < 1 && a->certificate > o->tolerance && d->m.nv < o->most;
}

int
conformal_grid(const Disk *d, const int corner[4], Chart g, const ConformalOptions *options,
	Conformal *c, SpdReport *report)
{
	int vertex[4], k, e;
	AdaptMap a;
	IntrinsicMap m;

	memset(c, 0, sizeof *c);
	for (k = 0; k < 4; k++)
		vertex[k] = d->loop[corner[k]];
	c->u = malloc(d->m.nv*sizeof *c->u);
	c->v = malloc(d->m.nv*sizeof *c->v);
	e = c->u && c->v ? adapt_map(d, vertex, &options->map, &a, report) : SPD_ENOMEM;
	if (!e) {
		e = missed(d, &a, &options->map) ? ADAPT_HARD : sample_adapted(d, corner, &a, g, options, c);
		adapt_free(&a);
	}
	if (e == ADAPT_HARD) {
		e = intrinsic_map(d, vertex, &options->map, &m, report);
		if (!e) {
			e = sample_intrinsic(d, corner, &m, g, options, c);
			intrinsic_map_free(&m);
		}
	}
	if (e)
		conformal_free(c);
	return e;
}

void
conformal_free(Conformal *c)
{
	grid_free(&c->grid);
	free(c->u);
	free(c->v);
	c->u = c->v = NULL;
}
