/* locate.c - point location by walking. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "locate.h"

static const double INSIDE = -1e-10;    /* least barycentric coordinate of a point inside */

static const double FLAT = 1e-12;       /* height of a triangle, in units of the longer side of the
                                         * chart, that is 0 up to rounding: (u,v) have errors of
                                         * 1e-16, and even a hundred times that must not decide */

static const double NARROW = 1e-7;      /* the same, that needles and near duplicates may have by the
                                         * errors of their own coordinates; far below any cell */

/* A triangle in (u,v): its sides from corner 0 to corners 1 and 2, and twice its signed area. */
typedef struct Image {
	double bu, bv, cu, cv, area;
} Image;

static Image
image(const Locator *l, int t)
{
	const int *c = &l->m->tri[3*(size_t)t];
	Image a = { .bu = l->u[c[1]] - l->u[c[0]], .bv = l->v[c[1]] - l->v[c[0]],
		.cu = l->u[c[2]] - l->u[c[0]], .cv = l->v[c[2]] - l->v[c[0]] };

	a.area = a.bu*a.cv - a.cu*a.bv;
	return a;
}

/* Whether the triangle is less high than `flat`, in units of the longer side of the chart. */
static int
is_thin(const Image *a, double T, double flat)
{
	double du = a->cu - a->bu, dv = a->cv - a->bv;
	double longest2 = fmax(a->bu*a->bu + a->bv*a->bv, fmax(a->cu*a->cu + a->cv*a->cv, du*du + dv*dv));

	flat *= fmax(1, T);
	return !(a->area*a->area > flat*flat*longest2);
}

int
locate_is_flat(const Locator *l, int t)
{
	Image a = image(l, t);

	return !(a.area > 0) || is_thin(&a, l->T, NARROW);
}

/* Sets w to the barycentric coordinates of (x,y) in triangle t.  Returns 0 if t has no area in
 * (u,v). */
static int
barycentric(const Locator *l, int t, double x, double y, double w[3])
{
	int o = l->m->tri[3*(size_t)t];
	Image a = image(l, t);

	x -= l->u[o];
	y -= l->v[o];
	w[1] = (x*a.cv - a.cu*y)/a.area;
	w[2] = (a.bu*y - x*a.bv)/a.area;
	w[0] = 1 - w[1] - w[2];
	return !is_thin(&a, l->T, FLAT) && isfinite(w[0]);
}

static int
least(const double w[3])
{
	return w[0] <= w[1] && w[0] <= w[2] ? 0 : w[1] <= w[2] ? 1 : 2;
}

/* The square of the distance of (x,y) from the middle of triangle t. */
static double
distance2(const Locator *l, int t, double x, double y)
{
	const int *c = &l->m->tri[3*(size_t)t];

	x -= (l->u[c[0]] + l->u[c[1]] + l->u[c[2]])/3;
	y -= (l->v[c[0]] + l->v[c[1]] + l->v[c[2]])/3;
	return x*x + y*y;
}

/* The triangle across the side of t opposite to corner k.  If that side is on the boundary or k is
 * -1, the neighbour of t whose middle is nearest to (x,y), except triangle `from`; -1 if there is
 * none. */
static int
step(const Locator *l, int t, int k, int from, double x, double y)
{
	int i, twin, best = -1;
	double nearest = 0, d;

	if (k >= 0 && l->twin[3*t + (k + 1)%3] >= 0)
		return l->twin[3*t + (k + 1)%3]/3;
	for (i = 0; i < 3; i++) {
		twin = l->twin[3*t + i];
		if (twin < 0 || twin/3 == from)
			continue;
		d = distance2(l, twin/3, x, y);
		if (best < 0 || d < nearest) {
			nearest = d;
			best = twin/3;
		}
	}
	return best;
}

/* Walks from triangle t towards the point (x,y).  Returns the triangle that contains the point or,
 * if the walk does not reach one, the visited triangle in which the least barycentric coordinate is
 * largest.  Sets w to the coordinates in the returned triangle. */
static int
walk(const Locator *l, int t, double x, double y, double w[3])
{
	double here[3], deepest = -HUGE_VAL;
	int best = t, from = -1, next, k, left = 64 + 4*(int)sqrt(l->m->nf);

	w[0] = w[1] = -1, w[2] = 3;     /* nothing found yet */
	for (; t >= 0 && left > 0; left--, from = t, t = next) {
		k = -1;         /* a flat triangle has no coordinates */
		if (barycentric(l, t, x, y, here)) {
			k = least(here);
			if (here[k] > deepest) {
				deepest = here[k];
				best = t;
				memcpy(w, here, sizeof here);
			}
			if (here[k] >= INSIDE)
				break;
			if (l->twin[3*t + (k + 1)%3] < 0 && here[(k + 1)%3] >= 0 && here[(k + 2)%3] >= 0)
				break;          /* the point lies beyond the boundary */
		}
		next = step(l, t, k, from, x, y);
	}
	return best;
}

/* Returns the triangle in which the least barycentric coordinate of (x,y) is largest: if several
 * contain the point, that in which it lies deepest.  On entry w are the coordinates in triangle
 * `best`, the result of the walk; on return w are those in the result. */
static int
search(const Locator *l, int best, double x, double y, double w[3])
{
	double here[3];
	int t;

	for (t = 0; t < l->m->nf; t++)
		if (barycentric(l, t, x, y, here) && here[least(here)] > w[least(w)]) {
			memcpy(w, here, sizeof here);
			best = t;
		}
	return best;
}

static int
place(double x, double length, int n)
{
	double i = x/length*n;

	return i >= n ? n - 1 : i > 0 ? (int)i : 0;
}

/* The corner of the chart at (x,y), 0..3 as in Locator, or -1. */
static int
corner_at(const Locator *l, double x, double y)
{
	return (x != 0 && x != 1) || (y != 0 && y != l->T) ? -1 : (x == 1) + 2*(y == l->T);
}

static void
find_corners(Locator *l)
{
	int s, c;

	for (c = 0; c < 4; c++)
		l->corner[c] = -1;
	for (s = 0; s < 3*l->m->nf; s++) {
		c = corner_at(l, l->u[l->m->tri[s]], l->v[l->m->tri[s]]);
		if (c >= 0 && l->corner[c] < 0)
			l->corner[c] = s;
	}
}

int
locate(const Locator *l, double x, double y, double bary[3])
{
	return locate_from(l, l->start[place(y, l->T, l->ny)*l->nx + place(x, 1, l->nx)], x, y, bary);
}

int
locate_from(const Locator *l, int from, double x, double y, double bary[3])
{
	int t, k, corner = corner_at(l, x, y);
	double sum = 0;

	if (corner >= 0 && l->corner[corner] >= 0) {
		for (k = 0; k < 3; k++)
			bary[k] = k == l->corner[corner]%3;
		return l->corner[corner]/3;
	}
	t = walk(l, from, x, y, bary);
	if (bary[least(bary)] < INSIDE)
		t = search(l, t, x, y, bary);
	for (k = 0; k < 3; k++)
		sum += bary[k] = fmax(bary[k], 0);
	for (k = 0; k < 3; k++)
		bary[k] /= sum;
	return t;
}

/* Sets each cell of the table to a triangle whose centroid is in the cell, or, if there is none, to
 * the triangle of the previous cell. */
static void
fill_table(Locator *l)
{
	int t, i, n = l->nx*l->ny, last = 0;

	for (i = 0; i < n; i++)
		l->start[i] = -1;
	for (t = 0; t < l->m->nf; t++) {
		const int *c = &l->m->tri[3*t];
		double x = (l->u[c[0]] + l->u[c[1]] + l->u[c[2]])/3;
		double y = (l->v[c[0]] + l->v[c[1]] + l->v[c[2]])/3;

		l->start[place(y, l->T, l->ny)*l->nx + place(x, 1, l->nx)] = t;
	}
	for (i = 0; i < n; i++)
		last = l->start[i] = l->start[i] >= 0 ? l->start[i] : last;
}

int
locator_init(Locator *l, const Disk *d, const double *u, const double *v, double T)
{
	int n = 1 + (int)sqrt(d->m.nf);

	*l = (Locator){ .m = &d->m, .u = u, .v = v, .twin = d->twin, .nx = n, .ny = n, .T = T };
	l->start = malloc((size_t)n*n*sizeof *l->start);
	if (!l->start)
		return MESH_ENOMEM;
	fill_table(l);
	find_corners(l);
	return 0;
}

void
locator_free(Locator *l)
{
	free(l->start);
	l->start = NULL;
}
