/* conformal.c - the conformal grid of a disk. */
#include <stdlib.h>
#include <string.h>

#include "conformal.h"
#include "untangle.h"

/* Mean modulus of the Beltrami coefficient below which a grid from linear elements is not
 * polished: the error of H then comes from the roughness of (u,v), and polishing gains nothing.
 * With quadratic elements it comes from what the polish leaves, so those are always polished. */
static const double ENOUGH = 2e-4;

/* Samples the mesh of the map and polishes the grid; the polish moves the vertices of d in the
 * chart with it. */
static int
sample(const Disk *d, const AdaptMap *a, Chart g, const ConformalOptions *options, Conformal *c)
{
	const Disk *sampled = options->surface == SAMPLER_SMOOTH ? d : &a->d;
	Sampler s;
	int e;

	if (sampler_init(&s, sampled, a->u, a->v, a->T, options->surface))
		return SPD_ENOMEM;
	g.T = a->T;
	e = grid_init(&c->grid, g, &s);
	if (!e) {
		memcpy(c->u, a->u, d->m.nv*sizeof *c->u);
		memcpy(c->v, a->v, d->m.nv*sizeof *c->v);
		e = polish(&s, &c->grid, options->polish, a->quadratic ? 0 : ENOUGH, d->m.nv, c->u, c->v, &c->polished);
	}
	sampler_free(&s);
	return e ? SPD_ENOMEM : 0;
}

/* Untangles the triangulation that will be sampled.  CONFORMAL_ETURNED if some triangles stay
 * turned and the options do not allow it. */
static int
untangle_sampled(const Disk *d, const int corner[4], AdaptMap *a, const ConformalOptions *options, Conformal *c)
{
	int e = options->surface == SAMPLER_SMOOTH ? untangle(d, corner, a->u, a->v, &c->turned)
	    : untangle(&a->d, a->corner, a->u, a->v, &c->turned);

	if (e)
		return SPD_ENOMEM;
	return c->turned && !options->keep_turned ? CONFORMAL_ETURNED : 0;
}

int
conformal_grid(const Disk *d, const int corner[4], Chart g, const ConformalOptions *options,
	Conformal *c, SpdReport *report)
{
	int vertex[4], k, e;
	AdaptMap a;

	memset(c, 0, sizeof *c);
	for (k = 0; k < 4; k++)
		vertex[k] = d->loop[corner[k]];
	e = adapt_map(d, vertex, &options->map, &a, report);
	if (e)
		return e;
	c->certificate = a.certificate;
	c->vertices = a.d.m.nv;
	c->u = malloc(d->m.nv*sizeof *c->u);
	c->v = malloc(d->m.nv*sizeof *c->v);
	e = c->u && c->v ? untangle_sampled(d, corner, &a, options, c) : SPD_ENOMEM;
	if (!e)
		e = sample(d, &a, g, options, c);
	adapt_free(&a);
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
