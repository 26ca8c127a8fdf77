/* conformal.c - the conformal grid of a disk. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../grid/gridloss.h"
#include "../intrinsic/overlay.h"
#include "../mesh/boundarysplit.h"
#include "../mesh/traversal.h"
#include "../poisson/plate.h"
#include "conformal.h"
#include "intrinsicmap.h"
#include "vertexkey.h"

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

/* Samples field k at the nodes of the finished grid.  x, y: their points of the rectangle. */
static int
sample_field(const Sampling *m, int k, const double *x, const double *y, Conformal *c)
{
	size_t nodes = (size_t)c->grid.g.nu*c->grid.g.nv;
	const double *f = m->options->field[k];
	double *all = NULL;
	Channel channel = { .n = 1 };
	int e = SPD_ENOMEM;

	if (m->s->l.m->nv > m->d->m.nv && (all = malloc(m->s->l.m->nv*sizeof *all)))
		subdivision_extend(m->mesh, 1, f, all);
	channel.f = all ? all : (double *)f;
	c->field[k] = malloc(nodes*sizeof(double));
	if (c->field[k] && (all || m->s->l.m->nv == m->d->m.nv))
		e = sampler_channel(m->s, &channel, c->grid.g, x, y, &c->field[k]) ? SPD_ENOMEM : 0;
	free(all);
	return e;
}

static int
sample_fields(const Sampling *m, Conformal *c)
{
	int n = c->grid.g.nu*c->grid.g.nv, p, k, e = 0;
	double *x;

	if (!m->options->fields)
		return 0;
	x = malloc(2*(size_t)n*sizeof *x);
	c->field = calloc(m->options->fields, sizeof *c->field);
	c->fields = c->field ? m->options->fields : 0;
	for (p = 0; x && p < n; p++)
		chartmap_point(&m->map, c->grid.x[p], c->grid.y[p], &x[p], &x[n+p]);
	for (k = 0; x && !e && k < c->fields; k++)
		e = sample_field(m, k, x, x + n, c);
	e = !x || !c->field ? SPD_ENOMEM : e;
	free(x);
	return e;
}

static int
sample_map(const Sampling *m, const int corner[4], Chart g, Conformal *c)
{
	UntangleChart on;
	int e, less;

	e = m->options->keep > 0 ? sample_enough(m, g, c) : sample_and_polish(m, g, 0, c, &less);
	if (!e)
		e = sample_fields(m, c);
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

/* The vertex of z nearest to the point a of the disk, as a hyperbolic distance; one on the boundary is
 * none. */
static int
nearest_vertex(int n, const double complex *z, double complex a)
{
	int i, best = -1;
	double d, least = HUGE_VAL;

	for (i = 0; i < n; i++) {
		d = cabs((z[i] - a)/(1 - conj(a)*z[i]));
		if (d < least && cabs(z[i]) < 1 - 1e-9) {
			least = d;
			best = i;
		}
	}
	return best;
}

/* Sets chi^2, and the cones of a sock; unless that is `wanted`, only if it might be clearly better.  z: of the
 * vertices, in the unit disk. */
static int
find_cones(const Disk *d, const int corner[4], const int given[2], int wanted, const double complex *z,
	Conformal *c)
{
	double complex at[4];
	Parts parts;
	int k;

	if (parts_init(&parts, &d->m, z))
		return SPD_ENOMEM;
	for (k = 0; k < 4; k++)
		at[k] = z[d->loop[corner[k]]];
	c->chi2[0] = parts_rectangle(&parts, at);
	for (k = 0; k < 2; k++)
		c->cone[k] = given[k];
	if (given[0] < 0 && (wanted || c->chi2[0] > CONFORMAL_CLEARLY)) {
		cones_choose(&parts, at);
		for (k = 0; k < 2; k++)
			c->cone[k] = nearest_vertex(d->m.nv, z, at[k]);
	}
	if (c->cone[0] >= 0 && c->cone[1] >= 0 && c->cone[0] != c->cone[1])
		c->chi2[1] = parts_sock(&parts, z[c->cone[0]], z[c->cone[1]]);
	parts_free(&parts);
	return 0;
}

/* Finds the cones, and makes the map of the chart.  *kind may become the sock. */
static int
make_chart(const Disk *d, const int corner[4], const ConformalOptions *o, Sampling *at, const ChartKind **kind,
	Conformal *c)
{
	double complex *z = malloc(d->m.nv*sizeof *z);
	double T = at->s->l.T;
	int i, e;

	if (!z)
		return SPD_ENOMEM;
	#pragma omp parallel for schedule(static)
	for (i = 0; i < d->m.nv; i++)
		z[i] = chartmap_disk(T, at->u[i], at->v[i]);
	e = find_cones(d, corner, o->cone, (*kind)->folded, z, c);
	if (!e && o->choose && c->chi2[1] > 0 && c->chi2[0] > CONFORMAL_CLEARLY*c->chi2[1])
		*kind = &CHART_SOCK;
	at->map = chartmap_rectangle(T);
	if (!e && (*kind)->folded) {
		if (c->chi2[1] > 0)
			at->map = chartmap_sock(T, z[c->cone[0]], z[c->cone[1]]);
		else
			e = CONFORMAL_ECONES;
	}
	free(z);
	return e;
}

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
	e = make_chart(d, corner, options, &at, &g.kind, c);
	if (!e && smooth && c->overlaid && sampler_overlay(&s, m->mesh, m->u, m->v))
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

/* The offset that, subtracted from the coordinates, brings a mesh far from the origin near it.  The
 * subtraction is exact: along each axis the offset is a multiple of a power of two that is not less
 * than the extent of the mesh, and lies between 0 and the middle of the mesh. */
static void
find_offset(const Mesh *m, double offset[3])
{
	double low[3] = { HUGE_VAL, HUGE_VAL, HUGE_VAL }, high[3] = { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL };
	double extent = 0;
	int i, c;

	for (i = 0; i < m->nv; i++)
		for (c = 0; c < 3; c++) {
			low[c] = fmin(low[c], m->xyz[3*(size_t)i + c]);
			high[c] = fmax(high[c], m->xyz[3*(size_t)i + c]);
		}
	for (c = 0; c < 3; c++)
		extent = fmax(extent, high[c] - low[c]);
	extent = exp2(ceil(log2(extent)));
	for (c = 0; c < 3; c++)
		offset[c] = extent*trunc((low[c]/2 + high[c]/2)/extent);
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

/* Makes t the disk d moved by -offset, near the origin, and numbered from one of its corners on.  to:
 * the corners in its loop.  Returns 0 or SPD_ENOMEM. */
static int
normalize(const Disk *d, const int corner[4], Traversal *t, int to[4], double offset[3])
{
	int vertex[4], k, start;
	size_t i;

	for (k = 0; k < 4; k++)
		vertex[k] = d->loop[corner[k]];
	start = corner[vertex_first(&d->m, vertex)];
	if (traversal_init(t, d, start))
		return SPD_ENOMEM;
	for (k = 0; k < 4; k++)
		to[k] = (corner[k] - start + d->nb)%d->nb;
	find_offset(&d->m, offset);
	for (i = 0; i < 3*(size_t)d->m.nv; i++)
		t->d.m.xyz[i] -= offset[i%3];
	return 0;
}

/* Puts x, given at the vertices of t, in the order of the vertices of the given disk. */
static int
restore_order(const Traversal *t, double **x)
{
	double *given = malloc(t->d.m.nv*sizeof *given);
	int i;

	if (!given)
		return SPD_ENOMEM;
	for (i = 0; i < t->d.m.nv; i++)
		given[i] = (*x)[t->number[i]];
	free(*x);
	*x = given;
	return 0;
}

/* The vertex of d that has that number in the traversal, -1 if it was added. */
static int
given_number(const Traversal *t, int number)
{
	int i = t->d.m.nv - 1;

	while (i >= 0 && t->number[i] != number)
		i--;
	return i;
}

/* Moves the grid back by the offset, and puts u and v in the order of the vertices of d. */
static int
restore(const Disk *d, const Traversal *t, const double offset[3], Conformal *c)
{
	size_t nodes = (size_t)c->grid.g.nu*c->grid.g.nv, i;
	int k;

	for (k = 0; k < 3; k++)
		for (i = 0; i < nodes; i++)
			c->grid.phi[k][i] += offset[k];
	if (restore_order(t, &c->u) || restore_order(t, &c->v))
		return SPD_ENOMEM;
	for (k = 0; k < 2 && c->grid.g.kind->folded; k++)
		c->cone[k] = given_number(t, c->cone[k]);
	if (!c->grid.g.kind->folded)
		c->uv.turned += boundary_split_turned(d, c->u, c->v);
	return 0;
}

/* The fields of the options in the order of the vertices of the traversal: pointers and numbers in one piece, to be
 * freed. */
static double **
order_fields(const Traversal *t, const ConformalOptions *o)
{
	size_t nv = t->d.m.nv, n = o->fields;
	double **field = malloc((n + 1)*sizeof *field + n*nv*sizeof(double)), *f;
	size_t k, i;

	if (!field)
		return NULL;
	for (f = (double *)(field + n + 1), k = 0; k < n; k++, f += nv) {
		field[k] = f;
		for (i = 0; i < nv; i++)
			f[t->number[i]] = o->field[k][i];
	}
	return field;
}

/* Points are added on edges; far from the origin, rounding of their coordinates would bend the
 * surface.  So the surface is mapped near the origin.  Ties are broken in favour of lower numbers, and
 * sums are rounded in the order of the numbers.  So the vertices and faces are first renumbered in a
 * way that does not depend on their numbers in d. */
int
conformal_grid(const Disk *d, const int corner[4], Chart g, const ConformalOptions *options,
	Conformal *c, SpdReport *report)
{
	ConformalOptions o = *options;
	Traversal near;
	double offset[3], **field;
	int to[4], k, e = normalize(d, corner, &near, to, offset);

	memset(c, 0, sizeof *c);
	if (e)
		return e;
	field = order_fields(&near, options);
	o.field = (const double *const *)field;
	for (k = 0; k < 2; k++)
		o.cone[k] = o.cone[k] < 0 ? -1 : near.number[o.cone[k]];
	c->u = malloc(d->m.nv*sizeof *c->u);
	c->v = malloc(d->m.nv*sizeof *c->v);
	e = c->u && c->v && field ? map_and_sample(&near.d, to, g, &o, c, report) : SPD_ENOMEM;
	if (!e)
		e = restore(d, &near, offset, c);
	else if (e == SPD_EINDEFINITE)
		report->column = given_number(&near, report->column);
	free(field);
	traversal_free(&near);
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
