/* resample.c - separable interpolation and averaging between grids.
 *
 * A grid with joined sides is first extended beyond them, by as many nodes as the weights reach; then it
 * is a rectangle like any other.
 */
#include <math.h>
#include <stdlib.h>

#include "resample.h"
#include "stencil.h"

/* Weights along one axis, for n new samples: e_i is the sum over k < count[i] of
 * weight[i*most + k] f[first[i] + k].  Nodes beyond joined sides have numbers below 0, or from the number
 * of nodes on. */
typedef struct Axis {
	int     n, most;
	int    *first, *count;
	double *weight;
} Axis;

static void
axis_free(Axis *a)
{
	free(a->first);
	free(a->count);
	free(a->weight);
}

/* The caller must free a, even if this fails. */
static int
axis_init(Axis *a, int n, int most)
{
	*a = (Axis){ n, most, malloc(n*sizeof(int)), malloc(n*sizeof(int)),
		malloc((size_t)n*most*sizeof(double)) };
	return a->first && a->count && a->weight ? 0 : RESAMPLE_ENOMEM;
}

static int
nodes_along(Chart g, int axis)
{
	return axis ? g.nv : g.nu;
}

/* Computes the weights of Lagrange interpolation from four nodes round each new node (from all nodes,
 * if there are fewer). */
static int
cubic_axis(Axis *a, Chart from, double end, Chart to, int axis)
{
	const int *joined = from.kind->joined[axis];
	int nodes = nodes_along(from, axis), points = nodes < 4 ? nodes : 4, i, k, l;
	double half = joined[0]*0.5, x;

	if (axis_init(a, nodes_along(to, axis), 4))
		return RESAMPLE_ENOMEM;
	for (i = 0; i < a->n; i++) {
		x = (i + half)*chart_steps(from, axis)/(chart_steps(to, axis)*end) - half;
		k = (int)floor(x) - (points - 1)/2;
		k = k < 0 && !joined[0] ? 0 : k > nodes - points && !joined[1] ? nodes - points : k;
		a->first[i] = k;
		a->count[i] = points;
		for (k = 0; k < points; k++)
			for (a->weight[4*i+k] = 1, l = 0; l < points; l++)
				if (l != k)
					a->weight[4*i+k] *= (x - a->first[i] - l)/(k - l);
	}
	return 0;
}

/* Whether node i along the axis lies on an open side. */
static int
on_open_side(Chart g, int axis, int i)
{
	return (i == 0 && !g.kind->joined[axis][0]) || (i == nodes_along(g, axis) - 1 && !g.kind->joined[axis][1]);
}

static int
mean_axis(Axis *a, Chart from, Chart to, int axis)
{
	double ratio = chart_steps(from, axis)/chart_steps(to, axis), half = from.kind->joined[axis][0]*0.5, x, sum;
	int most = 2*(int)ceil(ratio) + 1, i, k, last, open;

	if (axis_init(a, nodes_along(to, axis), most))
		return RESAMPLE_ENOMEM;
	for (i = 0; i < a->n; i++) {
		double *w = a->weight + (size_t)i*most;

		open = on_open_side(to, axis, i);
		x = open && i > 0 ? nodes_along(from, axis) - 1 : (i + half)*ratio - half;
		k = open ? (int)x : (int)floor(x - ratio) + 1;
		last = open ? (int)x : (int)ceil(x + ratio) - 1;
		a->first[i] = k;
		a->count[i] = last - k + 1;
		for (sum = 0; k <= last; k++)
			sum += w[k-a->first[i]] = fmax(1 - fabs(k - x)/ratio, 0);
		for (k = 0; k < a->count[i]; k++)
			w[k] /= sum;
	}
	return 0;
}

/* Resamples one line: f has samples at stride fstep, e gets a->n numbers at stride estep. */
static void
apply(const Axis *a, const double *f, long fstep, double *e, long estep)
{
	double sum;
	int i, k;

	for (i = 0; i < a->n; i++) {
		for (sum = 0, k = 0; k < a->count[i]; k++)
			sum += a->weight[(size_t)i*a->most+k]*f[(a->first[i] + k)*fstep];
		e[i*estep] = sum;
	}
}

/* How many nodes the weights reach before the first node of the grid and after the last. */
typedef struct Reach {
	int before, after;
} Reach;

static Reach
reach(const Axis *a, int nodes)
{
	Reach r = { 0, 0 };
	int i, last;

	for (i = 0; i < a->n; i++) {
		last = a->first[i] + a->count[i] - 1;
		r.before = -a->first[i] > r.before ? -a->first[i] : r.before;
		r.after = last - (nodes - 1) > r.after ? last - (nodes - 1) : r.after;
	}
	return r;
}

/* The field f with so many more columns and rows on each side.  To be freed; NULL if there is no memory. */
static double *
extend(Chart g, const double *f, Reach u, Reach v)
{
	size_t row = (size_t)u.before + g.nu + u.after;
	double *x = malloc(row*(v.before + g.nv + v.after)*sizeof *x), *next = x;
	int i, j, sign = 1;

	for (j = -v.before; x && j < g.nv + v.after; j++)
		for (i = -u.before; i < g.nu + u.after; i++)
			*next++ = f[stencil_node(g, i, j, &sign)];
	return x;
}

/* f has rows of `row` numbers, from row -below to row above-1. */
static int
apply_both(const Axis *u, const Axis *v, int row, int below, int above, const double *f, double *out)
{
	double *half = malloc((size_t)u->n*(below + above)*sizeof *half);
	int i, j;

	for (j = 0; half && j < below + above; j++)
		apply(u, f + (size_t)j*row, 1, half + (size_t)j*u->n, 1);
	for (i = 0; half && i < u->n; i++)
		apply(v, half + (size_t)below*u->n + i, u->n, out + i, u->n);
	free(half);
	return half ? 0 : RESAMPLE_ENOMEM;
}

static int
resample(const Axis *u, const Axis *v, Chart from, const double *f, double *out)
{
	Reach wide = reach(u, from.nu), high = reach(v, from.nv);
	int e = RESAMPLE_ENOMEM;
	double *x;

	if (!wide.before && !wide.after && !high.before && !high.after)
		return apply_both(u, v, from.nu, 0, from.nv, f, out);
	x = extend(from, f, wide, high);
	if (x)
		e = apply_both(u, v, wide.before + from.nu + wide.after, high.before, from.nv + high.after,
		    x + wide.before, out);
	free(x);
	return e;
}

int
resample_cubic(Chart from, const double end[2], const double *f, Chart to, double *e)
{
	Axis u = { 0 }, v = { 0 };
	int r = cubic_axis(&u, from, end[0], to, 0) || cubic_axis(&v, from, end[1], to, 1);

	r = r ? RESAMPLE_ENOMEM : resample(&u, &v, from, f, e);
	axis_free(&u);
	axis_free(&v);
	return r;
}

int
resample_mean(Chart from, const double *f, Chart to, double *e)
{
	Axis u = { 0 }, v = { 0 };
	int r = mean_axis(&u, from, to, 0) || mean_axis(&v, from, to, 1);

	r = r ? RESAMPLE_ENOMEM : resample(&u, &v, from, f, e);
	axis_free(&u);
	axis_free(&v);
	return r;
}
