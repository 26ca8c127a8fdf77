/* synth_mesh.c - triangulates the domain of a surface and maps its vertices onto the surface. */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "delaunay.h"
#include "rng.h"
#include "scatter.h"
#include "synth_shapes.h"

enum {
	PIECES = 2048,  /* pieces of a side, to measure its length */
	CELLS = 96      /* cells of the box in each direction, to measure the area */
};

/* Ratio of the spacing on the boundary to the least distance inside.  The mean edge length inside
 * is 1.23 least distances. */
static const double SPACING = 1.18;
/* Points inside per area of one least distance squared: 0.81 was measured on a plain square. */
static const double PACKING = 0.80;

/* The data of ScatterRule: the mesh of the surface is even if the points in the plane are r/scale
 * apart. */
typedef struct Plan {
	const Synth *s;
	SynthDomain  d;
	double       r;
	int          nb;        /* points on the boundary */
} Plan;

static double
scale(const Synth *s, double x, double y)
{
	const SynthKind *k = s->kind;

	return k->scale ? k->scale(s->p, x, y) : k->lambda ? k->lambda(s->p, x, y) : 1;
}

static double
plan_dist(const void *data, double x, double y)
{
	const Plan *plan = data;

	return plan->r/scale(plan->s, x, y);
}

static int
plan_inside(const void *data, double x, double y)
{
	return synth_inside(&((const Plan *)data)->d, x, y);
}

/* The number of sides of the domain, which are counted counterclockwise.  corner[k]: the side that
 * begins at corner k. */
static int
sides(const SynthDomain *d, int corner[4])
{
	static const int four[4] = { 0, 1, 2, 3 }, six[4] = { 0, 1, 3, 5 };

	memcpy(corner, d->shape == SYNTH_LSHAPE ? six : four, sizeof four);
	return d->shape == SYNTH_LSHAPE ? 6 : 4;
}

/* Sets x, y to the point at t in [0,1] of side k.  On straight sides the constant coordinate is
 * exact, so that there can be no sliver triangle between the side and the convex hull. */
static void
side_at(const SynthDomain *d, int k, double t, double *x, double *y)
{
	const double rect[5][2] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { 0, 0 } };
	const double ell[7][2] = { { 0, 0 }, { 1, 0 }, { 1, 0.5 }, { 0.5, 0.5 }, { 0.5, 1 },
		{ 0, 1 }, { 0, 0 } };
	const double (*c)[2] = d->shape == SYNTH_LSHAPE ? ell + k : rect + k;
	double a, u, v;

	if (d->shape == SYNTH_OVAL) {
		a = acos(-1)*((k + t)/2 - 0.75);
		u = (1 + cos(a))/2;
		v = (1 + sin(a))/2;
	} else {
		u = c[0][0] == c[1][0] ? c[0][0] : c[0][0] + t*(c[1][0] - c[0][0]);
		v = c[0][1] == c[1][1] ? c[0][1] : c[0][1] + t*(c[1][1] - c[0][1]);
	}
	*x = (1 - u)*d->x0 + u*d->x1;
	*y = (1 - v)*d->y0 + v*d->y1;
}

/* Sets len[i] to the length of the first i pieces of side k on the surface (weighted by scale).
 * Returns the length of the side. */
static double
side_lengths(const Plan *plan, int k, double len[PIECES + 1])
{
	double x0, y0, x, y;
	int i;

	len[0] = 0;
	side_at(&plan->d, k, 0, &x0, &y0);
	for (i = 1; i <= PIECES; i++, x0 = x, y0 = y) {
		side_at(&plan->d, k, (double)i/PIECES, &x, &y);
		len[i] = len[i-1] + hypot(x - x0, y - y0)*scale(plan->s, (x + x0)/2, (y + y0)/2);
	}
	return len[PIECES];
}

/* Appends evenly spaced points of side k, without its ends. */
static int
side_points(const Plan *plan, int k, Points *p)
{
	double len[PIECES + 1], target, t, x, y, n;
	int i, j = 0;

	n = floor(side_lengths(plan, k, len)/(SPACING*plan->r) + 0.5);
	for (i = 1; i < n; i++) {
		target = len[PIECES]*i/n;
		while (j < PIECES-1 && len[j+1] < target)
			j++;
		t = (j + (target - len[j])/(len[j+1] - len[j]))/PIECES;
		side_at(&plan->d, k, t, &x, &y);
		if (scatter_add(p, x, y))
			return SYNTH_ENOMEM;
	}
	return 0;
}

static int
boundary_points(const Plan *plan, Points *p)
{
	int corner[4], i, k, n = sides(&plan->d, corner);
	double x, y;

	for (i = 0; i < 4; i++) {
		side_at(&plan->d, corner[i], 0, &x, &y);
		if (scatter_add(p, x, y))
			return SYNTH_ENOMEM;
	}
	for (i = k = 0; k < n; k++) {
		if (i < 4 && corner[i] == k)
			i++;
		else {
			side_at(&plan->d, k, 0, &x, &y);
			if (scatter_add(p, x, y))
				return SYNTH_ENOMEM;
		}
		if (side_points(plan, k, p))
			return SYNTH_ENOMEM;
	}
	return 0;
}

/* Estimates the least distance r that gives n points.  With area A and perimeter P measured on the
 * surface, n r^2 = PACKING (A - P r/2) + P r/SPACING.  *top: the largest scale. */
static double
first_guess(const Plan *plan, int n, double *top)
{
	const SynthDomain *d = &plan->d;
	double len[PIECES + 1], dx = (d->x1 - d->x0)/CELLS, dy = (d->y1 - d->y0)/CELLS;
	double A = 0, P = 0, c, x, y, f;
	int corner[4], i, j, k;

	*top = 0;
	for (k = sides(d, corner) - 1; k >= 0; k--)
		P += side_lengths(plan, k, len);
	for (j = 0; j <= CELLS; j++)
		for (i = 0; i <= CELLS; i++) {
			x = d->x0 + i*dx;
			y = d->y0 + j*dy;
			f = scale(plan->s, x, y);
			*top = f > *top ? f : *top;
			x += dx/2;
			y += dy/2;
			if (synth_inside(d, x, y))
				A += dx*dy*pow(scale(plan->s, x, y), 2);
		}
	c = P*(1/SPACING - PACKING/2);
	return (c + sqrt(c*c + 4*n*PACKING*A))/(2*n);
}

static int
scatter_points(Plan *plan, double top, uint64_t seed, Points *p)
{
	ScatterRule rule = { plan->d.x0, plan->d.x1, plan->d.y0, plan->d.y1,
		0.98*plan->r/top, plan_dist, plan_inside, plan };

	p->n = 0;
	if (boundary_points(plan, p))
		return SYNTH_ENOMEM;
	plan->nb = p->n;
	return scatter(&rule, seed, p) ? SYNTH_ENOMEM : 0;
}

/* Makes about n points.  Packing and rounding differ from mesh to mesh: while the number of points
 * is too far from n, the distance is corrected and the points are made again. */
static int
fit_points(Plan *plan, int n, uint64_t seed, Points *p)
{
	double top, r = first_guess(plan, n, &top), off, best = DBL_MAX, keep = r;
	int round, err = 0;

	for (round = 0; round < 8 && !err; round++) {
		plan->r = r;
		err = scatter_points(plan, top, seed, p);
		off = fabs((double)p->n/n - 1);
		if (off < best)
			best = off, keep = r;
		if (off <= 0.04)
			return err;
		r *= pow((double)p->n/n, round < 4 ? 0.5 : 0.25);
	}
	plan->r = keep;
	return err ? err : scatter_points(plan, top, seed, p);
}

/* Drops the triangles across the notch of the L. */
static int
drop_outside(const SynthDomain *d, const double *xy, int *tri, int nf)
{
	int f, kept = 0;
	const int *t;

	for (f = 0; f < nf; f++) {
		t = tri + 3*f;
		if (synth_inside(d, (xy[2*t[0]] + xy[2*t[1]] + xy[2*t[2]])/3,
		    (xy[2*t[0]+1] + xy[2*t[1]+1] + xy[2*t[2]+1])/3))
			memmove(tri + 3*kept++, t, 3*sizeof *t);
	}
	return kept;
}

/* Maps the points onto the surface.  A disk with exactly the nb boundary points on its boundary
 * has 2 nv - 2 - nb faces (Euler). */
static int
map_points(const Plan *plan, const Points *p, Mesh *m)
{
	const Synth *s = plan->s;
	int err, i;

	m->nv = p->n;
	m->xyz = malloc((size_t)p->n*3*sizeof *m->xyz);
	m->tri = malloc((size_t)p->n*2*3*sizeof *m->tri);
	if (!m->xyz || !m->tri)
		return SYNTH_ENOMEM;
	if ((err = delaunay(p->n, p->xy, m->tri, &m->nf)))
		return err == DELAUNAY_ENOMEM ? SYNTH_ENOMEM : SYNTH_EMESH;
	if (plan->d.shape == SYNTH_LSHAPE)
		m->nf = drop_outside(&plan->d, p->xy, m->tri, m->nf);
	if (m->nf != 2*m->nv - 2 - plan->nb)
		return SYNTH_EMESH;
	for (i = 0; i < m->nv; i++)
		s->kind->phi(s->p, p->xy[2*i], p->xy[2*i+1], m->xyz + 3*i);
	return 0;
}

int
synth_mesh(const Synth *s, int n, uint64_t seed, Mesh *m, double **xy)
{
	Plan plan = { .s = s };
	Points p = { 0, 0, NULL };
	int err;

	memset(m, 0, sizeof *m);
	if ((err = synth_domain(s, &plan.d)))
		return err;
	if (plan.d.shape == SYNTH_SPHERE)
		return synth_sphere_mesh(s, n, seed, m, xy);
	if (!(err = fit_points(&plan, n, seed, &p)))
		err = map_points(&plan, &p, m);
	if (err)
		mesh_free(m);
	if (err || !xy)
		free(p.xy);
	else
		*xy = p.xy;
	return err;
}
