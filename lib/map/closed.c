/* closed.c - the conformal grid of a closed surface: sphere, cones, samples. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/pillowplane.h"
#include "../grid/gridloss.h"
#include "../poisson/plate.h"
#include "conformal.h"
#include "pillowpolish.h"
#include "spherecones.h"
#include "spherelike.h"

/* Of the faces.  Meshes whose faces cross keep up to one in a thousand turned over; where a limb is so long that its
 * tip is lost in rounding, more are (an ellipsoid 20 : 1, one in 250). */
static const double TURNED = 0.002;

/* As in conformal.c, for grids from linear elements. */
static const double ENOUGH = 2e-4;

/* A mapped surface and its sampling options. */
typedef struct Closed {
	const Disk    *d;
	SphereMap      map;     /* its Z becomes the place on the sphere of the pillow */
	SphereCones    cones;
	SphereLike     like;    /* if options->like is given */
	SphereSampler  s;
	const ConformalOptions *options;
} Closed;

/* ---- the grid -------------------------------------------------------- */

/* The numbers of nodes along u and v: those of g, or as many together, in cells about square, and such that transforms
 * are fast. */
static Chart
shape(const Closed *m, Chart g)
{
	double nodes = (double)g.nu*g.nv;

	g.T = m->cones.map.T;
	if (!(m->options->shape || m->options->keep > 0))
		return g;
	g.nu = 2*(int)fmax(floor(sqrt(nodes/g.T)/2 + 0.5), 4);
	g.nv = (int)fmax(floor(g.nu*g.T + 0.5), 6);
	return plate_fast(g);
}

static int
sample_and_polish(const Closed *m, Chart g, PillowGrid *a, int *polished)
{
	if (pillowgrid_init(a, shape(m, g), &m->s))
		return POLISH_ENOMEM;
	return pillowpolish(&m->s, a, m->options->like.phi[0] ? a->g.T : 0, m->options->polish, m->map.quadratic ? 0 : ENOUGH,
		polished);
}

/* Samples on the given grid, or with the fewest cells whose grid keeps options->keep of the area. */
static int
sample(const Closed *m, Chart g, PillowGrid *a, int *polished)
{
	const ConformalOptions *o = m->options;
	double least = o->keep*mesh_area(&m->d->m), area = least;
	int n, e;

	if (!(o->keep > 0))
		return sample_and_polish(m, g, a, polished);
	for (n = conformal_cells(0); ; n = conformal_cells(n)) {
		g.nu = g.nv = (n < o->most ? n : o->most) + 1;
		e = sample_and_polish(m, g, a, polished);
		if (e || (e = gridloss_area(a->g, a->phi, &area)) || area >= least || n >= o->most)
			return e;
		pillowgrid_free(a);
	}
}

/* ---- its surroundings ------------------------------------------------ */

/* The vertex of d nearest to the point p of the sphere. */
static int
nearest(const Closed *m, const Spinor p)
{
	double least = HUGE_VAL, far;
	int i, best = 0;

	for (i = 0; i < m->d->m.nv; i++) {
		far = cabs(moebius_cross(p, m->map.Z[i]));
		if (far < least) {
			least = far;
			best = i;
		}
	}
	return best;
}

static void
find_cones(const Closed *m, Conformal *c)
{
	static const double at[4][2] = { { 0, 0 }, { 0.5, 0 }, { 0.5, 1 }, { 0, 1 } };
	PillowPlane plane = pillowplane(m->cones.map.T);
	Spinor p;
	int k;

	for (k = 0; k < 4; k++) {
		pillowplane_z(&plane, at[k][0], at[k][1]*plane.T, p);
		c->cone[k] = k < 3 && m->options->cone[k] >= 0 ? m->options->cone[k] : nearest(m, p);
	}
}

/* The fields of the options at the nodes. */
static int
sample_fields(const Closed *m, const PillowGrid *a, Conformal *c)
{
	const ConformalOptions *o = m->options;
	int facets = o->surface == SAMPLER_FACETS, n = a->g.nu*a->g.nv, e = 0, k;
	double *all = facets && o->fields ? malloc(m->map.mesh.d.m.nv*sizeof *all) : NULL;

	if (o->fields && ((facets && !all) || !(c->field = calloc(o->fields, sizeof *c->field))))
		e = SPD_ENOMEM;
	for (k = 0; !e && k < o->fields; k++) {
		c->field[k] = malloc(n*sizeof **c->field);
		c->fields = k + 1;
		if (all)
			subdivision_extend(&m->map.mesh, 1, o->field[k], all);
		e = !c->field[k] || spheresampler_field(&m->s, all ? all : o->field[k], n, a->at, c->field[k]) ? SPD_ENOMEM : 0;
	}
	free(all);
	return e;
}

/* Fills in c, which gets the positions of a. */
static int
fill(const Closed *m, PillowGrid *a, Conformal *c)
{
	int nv = m->d->m.nv, k, e = sample_fields(m, a, c);

	c->u = malloc(nv*sizeof *c->u);
	c->v = malloc(nv*sizeof *c->v);
	if (!e && c->u && c->v)
		e = pillowgrid_uv(a, nv, m->map.Z, c->u, c->v);
	else
		e = SPD_ENOMEM;
	find_cones(m, c);
	c->grid.g = a->g;
	for (k = 0; k < 3; k++)
		c->grid.phi[k] = a->phi[k];
	a->phi[0] = NULL;
	c->certificate = m->map.certificate;
	c->vertices = m->map.mesh.d.m.nv;
	c->full = m->map.mesh.d.m.nv >= m->options->map.most;
	c->overlaid = m->s.overlaid;
	c->solved_turned = m->map.turned;
	return e ? SPD_ENOMEM : 0;
}

/* ---- in order -------------------------------------------------------- */

/* Finds the cones that correspond to those of options->like. */
static int
follow_cones(Closed *m, const int *given)
{
	const Mesh *mesh = &m->map.mesh.d.m;
	const ConformalLike *like = &m->options->like;
	int e = spherelike(mesh, m->map.Z, given, like->g, like->phi, &m->like);

	if (e)
		return e == SPHERELIKE_EEQUAL ? CONFORMAL_ECONES : SPD_ENOMEM;
	m->cones.map = m->like.map;
	return spherecones_chi2(mesh, m->map.Z, &m->cones) ? SPD_ENOMEM : 0;
}

static int
find_best_cones(Closed *m, const int *given)
{
	int e = spherecones(&m->map.mesh.d.m, m->map.Z, given, &m->cones);

	return !e ? 0 : e == SPHERECONES_EEQUAL ? CONFORMAL_ECONES : SPD_ENOMEM;
}

/* Finds the cones, and moves the places of the map to the sphere of the pillow. */
static int
choose_cones(Closed *m)
{
	const int *given = m->options->cone[0] >= 0 ? m->options->cone : NULL;
	int i, e = m->options->like.phi[0] ? follow_cones(m, given) : find_best_cones(m, given);

	if (e)
		return e;
	#pragma omp parallel for schedule(static)
	for (i = 0; i < m->map.mesh.d.m.nv; i++) {
		Spinor w;

		conemap_move(&m->cones.map, m->map.Z[i], w);
		m->map.Z[i][0] = w[0];
		m->map.Z[i][1] = w[1];
	}
	return 0;
}

static int
sample_map(Closed *m, Chart g, Conformal *c)
{
	PillowGrid a = { .at = NULL };
	int e = spheresampler_init(&m->s, m->d, &m->map.mesh, m->map.Z, m->options->surface);

	if (e)
		return e == SPHERESAMPLER_ECOARSE ? CONFORMAL_ECOARSE : SPD_ENOMEM;
	e = sample(m, g, &a, &c->polished) ? SPD_ENOMEM : fill(m, &a, c);
	pillowgrid_free(&a);
	spheresampler_free(&m->s);
	return e;
}

int
conformal_closed(const Disk *d, Chart g, const ConformalOptions *options, Conformal *c, SpdReport *report)
{
	Closed m = { .d = d, .options = options };
	int e = sphere_map(d, &options->map, &m.map, report);

	memset(c, 0, sizeof *c);
	if (e)
		return e;
	g.kind = &CHART_PILLOW;
	e = choose_cones(&m);
	c->chi2[1] = e ? 0 : m.cones.chi2;
	c->apart[0] = m.like.rms;
	c->apart[1] = m.like.next;
	if (!e && m.map.turned > TURNED*m.map.mesh.d.m.nf)
		e = CONFORMAL_ETURNED;
	if (!e && options->chi2 > 0 && !(m.cones.chi2 <= options->chi2))
		e = CONFORMAL_ECHI2;
	if (!e)
		e = sample_map(&m, g, c);
	sphere_free(&m.map);
	if (e)
		conformal_free(c);
	return e;
}
