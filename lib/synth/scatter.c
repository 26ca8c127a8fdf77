/* scatter.c - dart throwing (Bridson), with a grid of cells that hold at most one point each. */
#include <limits.h>
#include <math.h>
#include <stdlib.h>

#include "rng.h"
#include "scatter.h"

/* On a plain square, the radius of the largest empty circle is 1.39 times the least distance with 7
 * tries, 1.08 with 11, 1.07 with 20. */
enum { TRIES = 11 };

typedef struct Cells {
	int    nx, ny;
	double x0, y0, step;
	int   *at;              /* [ny][nx] point in the cell, or -1 */
} Cells;

int
scatter_add(Points *p, double x, double y)
{
	double *xy;
	int max;

	if (p->n == p->max) {
		if (p->max > INT_MAX/4)
			return SCATTER_ENOMEM;
		max = p->max ? 2*p->max : 1024;
		if (!(xy = realloc(p->xy, (size_t)max*2*sizeof *xy)))
			return SCATTER_ENOMEM;
		p->xy = xy;
		p->max = max;
	}
	p->xy[2*p->n] = x;
	p->xy[2*p->n+1] = y;
	p->n++;
	return 0;
}

/* Makes cells of side rmin/2.  Their diagonal is rmin/sqrt(2), so points farther apart than that
 * never share a cell. */
static int
cells_make(Cells *c, const ScatterRule *rule)
{
	double nx, ny;
	size_t i, n;

	c->step = rule->rmin/2;
	nx = floor((rule->x1 - rule->x0)/c->step) + 1;
	ny = floor((rule->y1 - rule->y0)/c->step) + 1;
	if (!(nx < INT_MAX && ny < INT_MAX && nx*ny < (double)(SIZE_MAX/2/sizeof *c->at)))
		return SCATTER_ENOMEM;
	c->nx = (int)nx;
	c->ny = (int)ny;
	c->x0 = rule->x0;
	c->y0 = rule->y0;
	n = (size_t)c->nx*(size_t)c->ny;
	if (!(c->at = malloc(n*sizeof *c->at)))
		return SCATTER_ENOMEM;
	for (i = 0; i < n; i++)
		c->at[i] = -1;
	return 0;
}

static int
clip(double i, int n)
{
	return i < 0 ? 0 : i > n-1 ? n-1 : (int)i;
}

static void
cells_put(Cells *c, double x, double y, int k)
{
	int i = clip((x - c->x0)/c->step, c->nx), j = clip((y - c->y0)/c->step, c->ny);

	c->at[(size_t)j*(size_t)c->nx + (size_t)i] = k;
}

/* Whether no point lies within r of (x,y). */
static int
cells_free(const Cells *c, const Points *p, double x, double y, double r)
{
	int i0 = clip((x - r - c->x0)/c->step, c->nx), i1 = clip((x + r - c->x0)/c->step, c->nx);
	int j0 = clip((y - r - c->y0)/c->step, c->ny), j1 = clip((y + r - c->y0)/c->step, c->ny);
	int i, j, k;
	double dx, dy;

	for (j = j0; j <= j1; j++)
		for (i = i0; i <= i1; i++) {
			k = c->at[(size_t)j*(size_t)c->nx + (size_t)i];
			if (k < 0)
				continue;
			dx = p->xy[2*k] - x;
			dy = p->xy[2*k+1] - y;
			if (dx*dx + dy*dy < r*r)
				return 0;
		}
	return 1;
}

/* The length of a step from (x,y) along the unit vector (cx,cy).  It is at least the least distance
 * at the end of the step, if that distance grows slowly. */
static double
stride(const ScatterRule *rule, double x, double y, double cx, double cy)
{
	double r = rule->dist(rule->data, x, y), there;
	int i;

	for (i = 0; i < 3; i++) {
		there = rule->dist(rule->data, x + r*cx, y + r*cy);
		if (!(there > r))
			break;
		r = there;
	}
	return r;
}

/* Tries new points around point k, in evenly spaced directions from a random first one, at
 * distances of 1 to 1.15 times the least distance. */
static int
throw_darts(const ScatterRule *rule, Cells *c, Points *p, int k, uint64_t *rng)
{
	const double turn = 2*acos(-1);
	double x, y, a, r, u, x0 = p->xy[2*k], y0 = p->xy[2*k+1];
	int t;

	a = turn*rng_unit(rng);
	for (t = 0; t < TRIES; t++, a += turn/TRIES) {
		u = rng_unit(rng);
		r = stride(rule, x0, y0, cos(a), sin(a))*(1.0001 + 0.15*u*u);
		x = x0 + r*cos(a);
		y = y0 + r*sin(a);
		if (!rule->inside(rule->data, x, y))
			continue;
		if (!cells_free(c, p, x, y, rule->dist(rule->data, x, y)))
			continue;
		if (scatter_add(p, x, y))
			return SCATTER_ENOMEM;
		cells_put(c, x, y, p->n - 1);
	}
	return 0;
}

int
scatter(const ScatterRule *rule, uint64_t seed, Points *p)
{
	Cells c;
	int k, err = 0;

	if (cells_make(&c, rule))
		return SCATTER_ENOMEM;
	for (k = 0; k < p->n; k++)
		cells_put(&c, p->xy[2*k], p->xy[2*k+1], k);
	for (k = 0; k < p->n && !err; k++)
		err = throw_darts(rule, &c, p, k, &seed);
	free(c.at);
	return err;
}
