/* conformal.c - the conformal grid of a disk. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../grid/gridloss.h"
#include "../intrinsic/overlay.h"
#include "../mesh/boundarysplit.h"
#include "../poisson/plate.h"
#include "choosechart.h"
#include "intrinsicmap.h"
#include "near.h"
#include "nodefields.h"

/* A grid from linear elements is not polished if its mean modulus of the Beltrami coefficient is at
 * most this: the error of H then comes from the roughness of (u,v), which polishing does not
 * lower.  Grids from quadratic elements are always polished. */
static const double ENOUGH = 2e-4;

/* A map and its sampling options.  u and v begin with the values at the vertices of d. */
typedef struct Sampling {
	const Sampler *s;
	const Disk    *d;
	const double  *u, *v;
	double         enough;
	const ConformalOptions *options;
	ChartMap       map;
	const Subdivision *mesh;        /* of the solve */
} Sampling;

/* The numbers of nodes along u and v: those of g, or on a sock as many together, in cells about square, and
 * such that transforms are fast. */
static void
shape(const Sampling *m, Chart *g)
{
	double nodes = (double)g->nu*g->nv;

	if (!g->kind->folded || !(m->options->shape || m->options->keep > 0))
		return;
	g->nu = 2*(int)fmax(floor(sqrt(nodes/m->map.chart_T)/2 + 0.5), 4);
	g->nv = (int)fmax(floor(g->nu*m->map.chart_T + 1), 6);
	*g = plate_fast(*g);
}

/* The (u,v) of the vertices of d. */
static void
vertices_on_chart(const Sampling *m, Conformal *c)
{
	int i;

	#pragma omp parallel for schedule(static)
	for (i = 0; i < m->d->m.nv; i++)
		chartmap_uv(&m->map, m->u[i], m->v[i], &c->u[i], &c->v[i]);
}

/* Samples a map on the grid g and polishes the grid, which also moves the vertices of d in the
 * chart.  If the area of the grid is below `least` before or after the polish, *less is set, and the
 * grid is freed. */
static int
sample_and_polish(const Sampling *m, Chart g, double least, Conformal *c, int *less)
{
	double area = least;
	int e;

	shape(m, &g);
	if (grid_init(&c->grid, &m->map, g.nu, g.nv, m->s))
		return SPD_ENOMEM;
	vertices_on_chart(m, c);
	e = least > 0 && gridloss_area(c->grid.g, c->grid.phi, &area);
	if (!e && area >= least) {
		e = polish(m->s, &c->grid, m->options->polish, m->enough, m->d->m.nv, c->u, c->v, &c->polished)
		    || (least > 0 && gridloss_area(c->grid.g, c->grid.phi, &area));
	}
	*less = area < least;
	if (!e && *less)
		grid_free(&c->grid);
	return e ? SPD_ENOMEM : 0;
}

/* Samples with the fewest cells whose grid has at least options->keep times the area of d. */
static int
sample_enough(const Sampling *m, Chart g, Conformal *c)
{
	const double least = m->options->keep*mesh_area(&m->d->m);
	int n, less = 1, e = 0;

	for (n = conformal_cells(0); less && !e; n = conformal_cells(n)) {
		g.nu = g.nv = (n < m->options->most ? n : m->options->most) + 1;
		e = sample_and_polish(m, g, n < m->options->most ? least : 0, c, &less);
	}
	return e;
}

static int
sample_map(const Sampling *m, const int corner[4], Chart g, Conformal *c)
{
	UntangleChart on;
	int e, less;

	e = m->options->keep > 0 ? sample_enough(m, g, c) : sample_and_polish(m, g, 0, c, &less);
	if (!e)
		e = nodefields(m->s, &m->map, m->mesh, m->d, m->options, c);
	on = (UntangleChart){ g.kind, c->grid.g.T, .cone = { c->cone[0], c->cone[1] } };
	memcpy(on.corner, corner, sizeof on.corner);
	return e || untangle(m->d, &on, c->u, c->v, &c->uv) ? SPD_ENOMEM : 0;
}

/* A map of d, solved on a finer mesh. */
typedef struct Solved {
	const Subdivision *mesh;
	const double      *u, *v;       /* [mesh->d.m.nv] */
	double             T, enough;
} Solved;

/* Samples the surface.  A smooth surface is sampled on d, except near triangles of d that the map
 * turns over or makes flat: there the facets of the finer mesh are sampled.  A surface of facets is
 * sampled on the finer mesh everywhere. */
static int
sample(const Disk *d, const int corner[4], const Solved *m, Chart g, const ConformalOptions *options,
	Conformal *c)
{
	int smooth = options->surface == SAMPLER_SMOOTH, e;
	Sampler s;
	Sampling at = { .s = &s, .d = d, .u = m->u, .v = m->v, .enough = m->enough, .options = options,
	    .mesh = m->mesh };

	if (sampler_init(&s, smooth ? d : &m->mesh->d, m->u, m->v, m->T, options->surface))
		return SPD_ENOMEM;
	e = choosechart(d, corner, &(Rectangle){ m->T, m->u, m->v }, options, &g.kind, &at.map, c);
	if (!e && smooth && c->overlaid && sampler_overlay(&s, m->mesh, m->u, m->v, NULL))
		e = SPD_ENOMEM;
	if (!e)
		e = sample_map(&at, corner, g, c);
	sampler_free(&s);
	return e;
}

/* The number of triangles of d near which the facets must be sampled. */
static int
count_flat(const Disk *d, const double *u, const double *v, double T)
{
	Locator l = { .m = &d->m, .u = u, .v = v, .T = T };
	int t, n = 0;

	for (t = 0; t < d->m.nf; t++)
		n += locate_is_flat(&l, t);
	return n;
}

static int
sample_adapted(const Disk *d, const int corner[4], const AdaptMap *a, Chart g,
	const ConformalOptions *options, Conformal *c)
{
	Solved m = { &a->mesh, a->u, a->v, a->T, a->quadratic ? 0 : ENOUGH };

	c->certificate = a->certificate;
	c->vertices = a->mesh.d.m.nv;
	c->full = a->mesh.d.m.nv >= options->map.most;
	c->overlaid = count_flat(d, a->u, a->v, a->T);
	return sample(d, corner, &m, g, options, c);
}

static int
sample_intrinsic(const Disk *d, const int corner[4], IntrinsicMap *a, Chart g,
	const ConformalOptions *options, Conformal *c)
{
	Solved m = { &a->s.mesh, NULL, NULL, a->T, a->quadratic ? 0 : ENOUGH };

	c->certificate = a->certificate;
	c->vertices = a->s.t.nv;
	c->full = a->full;
	c->solved_turned = a->turned;
	c->overlaid = count_flat(d, a->u, a->v, a->T);
	if ((c->overlaid || options->surface == SAMPLER_FACETS) && overlay(&a->s.t, &a->s.mesh, &a->u, &a->v))
		return SPD_ENOMEM;
	m.u = a->u, m.v = a->v;
	return sample(d, corner, &m, g, options, c);
}

/* Whether adapt_map missed the tolerance although it was allowed to add vertices. */
static int
missed(const Disk *d, const AdaptMap *a, const AdaptOptions *o)
{
	return o->tolerance < 1 && a->certificate > o->tolerance && d->m.nv < o->most;
}

static int
map_and_sample(const Disk *d, const int corner[4], Chart g, const ConformalOptions *options,
	Conformal *c, SpdReport *report)
{
	int vertex[4], k, e;
	AdaptMap a;
	IntrinsicMap m;

	for (k = 0; k < 4; k++)
		vertex[k] = d->loop[corner[k]];
	e = adapt_map(d, vertex, &options->map, &a, report);
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
	return e;
}

/* Moves the grid back by the offset, and puts u and v in the order of the vertices of d. */
static int
restore(const Disk *d, const Near *near, Conformal *c)
{
	size_t nodes = (size_t)c->grid.g.nu*c->grid.g.nv, i;
	int k;

	for (k = 0; k < 3; k++)
		for (i = 0; i < nodes; i++)
			c->grid.phi[k][i] += near->offset[k];
	if (near_restore(near, &c->u) || near_restore(near, &c->v))
		return SPD_ENOMEM;
	for (k = 0; k < 2 && c->grid.g.kind->folded; k++)
		c->cone[k] = near_given(near, c->cone[k]);
	if (!c->grid.g.kind->folded)
		c->uv.turned += boundary_split_turned(d, c->u, c->v);
	return 0;
}

int
conformal_grid(const Disk *d, const int corner[4], Chart g, const ConformalOptions *options,
	Conformal *c, SpdReport *report)
{
	ConformalOptions o = *options;
	Near near;
	double **field;
	int k, e = near_init(&near, d, corner) ? SPD_ENOMEM : 0;

	memset(c, 0, sizeof *c);
	if (e)
		return e;
	field = near_fields(&near, options->fields, options->field);
	o.field = (const double *const *)field;
	for (k = 0; k < 2; k++)
		o.cone[k] = o.cone[k] < 0 ? -1 : near.t.number[o.cone[k]];
	c->u = malloc(d->m.nv*sizeof *c->u);
	c->v = malloc(d->m.nv*sizeof *c->v);
	e = c->u && c->v && field ? map_and_sample(&near.t.d, near.corner, g, &o, c, report) : SPD_ENOMEM;
	if (!e)
		e = restore(d, &near, c);
	else if (e == SPD_EINDEFINITE)
		report->column = near_given(&near, report->column);
	free(field);
	near_free(&near);
	if (e)
		conformal_free(c);
	return e;
}

void
conformal_free(Conformal *c)
{
	int k;

	grid_free(&c->grid);
	free(c->u);
	free(c->v);
	for (k = 0; k < c->fields; k++)
		free(c->field[k]);
	free(c->field);
	c->u = c->v = NULL;
	c->field = NULL;
	c->fields = 0;
}
