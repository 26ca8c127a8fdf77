/* inverse.c - fixed-point iteration, and where it does not contract, a search of quarters of cells. */
#include <math.h>
#include <stdlib.h>

#include "../grid/bicubic.h"
#include "inverse.h"

enum { MOST_STEPS = 100 };
static const double NEAR = 1e-9;        /* last step of the iteration, in grid steps */
static const double CONTRACTION = 0.8;  /* a step longer than this times the one before ends the
                                         * iteration: it might wander, and rounding errors decide
                                         * where it ends */

static double
clamp(double x, int most)
{
	return fmin(fmax(x, 0), most);
}

/* Keeps x, a coordinate along an axis, between the open sides. */
static double
between(Chart g, int axis, double x)
{
	const int *joined = g.kind->joined[axis];

	x = joined[0] ? x : fmax(x, 0);
	return joined[1] ? x : fmin(x, (axis ? g.nv : g.nu) - 1);
}

/* Iterates x = i - du(x,y), y = j - dv(x,y).  Returns whether the steps shrink to NEAR. */
static int
iterate(Chart g, const Shift *s, int i, int j, double *x, double *y)
{
	double before = HUGE_VAL, step = HUGE_VAL, nx = i, ny = j, ox, oy;
	int k;

	for (k = 0; k < MOST_STEPS && step > NEAR; k++) {
		Bicubic at = bicubic_at(g, nx, ny);

		ox = nx, oy = ny;
		nx = between(g, 0, i - bicubic_odd(&at, s->du));
		ny = between(g, 1, j - bicubic_odd(&at, s->dv));
		step = hypot(nx - ox, ny - oy);
		if (step > NEAR && step > CONTRACTION*before)
			break;
		before = step;
	}
	*x = nx, *y = ny;
	return step <= NEAR;
}

/* A point of the grid and its image; a quarter of a cell. */
typedef struct Point {
	double x, y, a, b;
} Point;

typedef struct Quarter {
	Point  corner[3];
	double area;            /* twice that of the image */
} Quarter;

/* What is filled in: the points of the nodes at which the iteration failed. */
typedef struct Inverse {
	Chart          g;
	double        *x, *y;   /* [nv][nu]; x is NaN where there is none yet */
	unsigned char *failed;  /* [nv][nu] */
} Inverse;

static Point
node(Chart g, const Shift *s, int p)
{
	double x = p%g.nu, y = p/g.nu;

	return (Point){ x, y, x + s->du[p], y + s->dv[p] };
}

/* The interval [lo, hi] of the image of q at height j; empty if there is none. */
static void
interval(const Quarter *q, int j, double *lo, double *hi)
{
	int k;

	*lo = HUGE_VAL, *hi = -HUGE_VAL;
	for (k = 0; k < 3; k++) {
		const Point *p = &q->corner[k], *r = &q->corner[(k+1)%3];
		double b = p->b - j, d = r->b - j, at;

		if ((b > 0 && d > 0) || (b < 0 && d < 0))
			continue;
		at = b == d ? r->a : p->a + b/(b - d)*(r->a - p->a);
		*lo = fmin(*lo, fmin(at, b == d ? p->a : at));
		*hi = fmax(*hi, fmax(at, b == d ? p->a : at));
	}
}

/* Sets the point of node (i,j), which is in the image of q, unless it has a nearer one. */
static void
set_point(const Inverse *v, const Quarter *q, int i, int j)
{
	const Point *o = &q->corner[0], *p = &q->corner[1], *r = &q->corner[2];
	size_t k = (size_t)j*v->g.nu + i;
	double w1 = ((i - o->a)*(r->b - o->b) - (r->a - o->a)*(j - o->b))/q->area;
	double w2 = ((p->a - o->a)*(j - o->b) - (i - o->a)*(p->b - o->b))/q->area;
	double x = clamp(o->x + w1*(p->x - o->x) + w2*(r->x - o->x), v->g.nu - 1);
	double y = clamp(o->y + w1*(p->y - o->y) + w2*(r->y - o->y), v->g.nv - 1);

	if (!v->failed[k] || !(isnan(v->x[k]) || hypot(x - i, y - j) < hypot(v->x[k] - i, v->y[k] - j)))
		return;
	v->x[k] = x, v->y[k] = y;
}

/* Sets the points of the nodes in the image of q, unless q is turned over or flat. */
static void
fill(const Inverse *v, const Quarter *q)
{
	const Point *c = q->corner;
	double low = fmin(c[0].b, fmin(c[1].b, c[2].b)), high = fmax(c[0].b, fmax(c[1].b, c[2].b)), lo, hi;
	int i, j;

	if (!(q->area > 0))
		return;
	for (j = (int)ceil(clamp(low - NEAR, v->g.nv)); j <= high + NEAR && j < v->g.nv; j++) {
		interval(q, j, &lo, &hi);
		for (i = (int)ceil(clamp(lo - NEAR, v->g.nu)); i <= hi + NEAR && i < v->g.nu; i++)
			set_point(v, q, i, j);
	}
}

/* Fills in the images of the four quarters of the cell whose first node is p.  (Two halves would
 * distinguish one diagonal.) */
static void
fill_cell(const Inverse *v, const Shift *s, int p)
{
	const Point c[4] = { node(v->g, s, p), node(v->g, s, p + 1), node(v->g, s, p + 1 + v->g.nu),
		node(v->g, s, p + v->g.nu) };
	Point o = { c[0].x + 0.5, c[0].y + 0.5, (c[0].a + c[1].a + c[2].a + c[3].a)/4,
		(c[0].b + c[1].b + c[2].b + c[3].b)/4 };
	int k;

	for (k = 0; k < 4; k++) {
		Quarter q = { { o, c[k], c[(k+1)%4] }, 0 };
		const Point *a = &q.corner[1], *b = &q.corner[2];

		q.area = (a->a - o.a)*(b->b - o.b) - (b->a - o.a)*(a->b - o.b);
		fill(v, &q);
	}
}

int
shift_inverse(Chart g, const Shift *s, double *x, double *y)
{
	int n = g.nu*g.nv, p, any = 0;
	Inverse v = { g, x, y, malloc(n) };

	if (!v.failed)
		return INVERSE_ENOMEM;
	#pragma omp parallel for schedule(dynamic, 256)
	for (p = 0; p < n; p++)
		v.failed[p] = !iterate(g, s, p%g.nu, p/g.nu, &x[p], &y[p]);
	for (p = 0; p < n; p++)
		if (v.failed[p])
			any = 1, x[p] = NAN;
	for (p = 0; any && p < n - g.nu; p++)
		if (p%g.nu < g.nu - 1)
			fill_cell(&v, s, p);
	for (p = 0; any && p < n; p++)
		if (isnan(x[p])) {              /* in no image, by rounding or folds */
			x[p] = between(g, 0, p%g.nu - s->du[p]);
			y[p] = between(g, 1, p/g.nu - s->dv[p]);
		}
	free(v.failed);
	return 0;
}
