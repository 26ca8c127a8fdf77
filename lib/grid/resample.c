/* resample.c - separable interpolation and averaging between grids. */
#include <math.h>
#include <stdlib.h>

#include "resample.h"

/* Weights along one axis, for n new samples: e_i is the sum over k < count[i] of
 * weight[i*most + k] f[first[i] + k]. */
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

/* Computes the weights of Lagrange interpolation from four nodes round each new node (from all nodes,
 * if there are fewer). */
static int
cubic_axis(Axis *a, int from, double end, int to)
{
	int points = from < 4 ? from : 4, i, k, l;
	double x;

	if (axis_init(a, to, 4))
		return RESAMPLE_ENOMEM;
	for (i = 0; i < to; i++) {
		x = i*(from - 1.0)/((to - 1.0)*end);
		k = (int)floor(x) - (points - 1)/2;
		k = k < 0 ? 0 : k > from - points ? from - points : k;
		a->first[i] = k;
		a->count[i] = points;
		for (k = 0; k < points; k++)
			for (a->weight[4*i+k] = 1, l = 0; l < points; l++)
				if (l != k)
					a->weight[4*i+k] *= (x - a->first[i] - l)/(k - l);
	}
	return 0;
}

static int
mean_axis(Axis *a, int from, int to)
{
	double ratio = (from - 1.0)/(to - 1.0), x, sum;
	int most = 2*(int)ceil(ratio) + 1, i, k, last;

	if (axis_init(a, to, most))
		return RESAMPLE_ENOMEM;
	for (i = 0; i < to; i++) {
		double *w = a->weight + (size_t)i*most;

		x = i == to - 1 ? from - 1 : i*ratio;
		k = i == 0 || i == to - 1 ? (int)x : (int)floor(x - ratio) + 1;
		last = i == 0 || i == to - 1 ? (int)x : (int)ceil(x + ratio) - 1;
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

static int
apply_both(Axis *u, Axis *v, int e, int fnu, int fnv, const double *f, double *out)
{
	double *half = e ? NULL : malloc((size_t)u->n*fnv*sizeof *half);
	int i, j;

	if (half) {
		for (j = 0; j < fnv; j++)
			apply(u, f + (size_t)j*fnu, 1, half + (size_t)j*u->n, 1);
		for (i = 0; i < u->n; i++)
			apply(v, half + i, u->n, out + i, u->n);
	}
	free(half);
	return half ? 0 : RESAMPLE_ENOMEM;
}

int
resample_cubic(Chart from, const double end[2], const double *f, Chart to, double *e)
{
	Axis u = { 0 }, v = { 0 };
	int r = cubic_axis(&u, from.nu, end[0], to.nu) || cubic_axis(&v, from.nv, end[1], to.nv);

	r = apply_both(&u, &v, r, from.nu, from.nv, f, e);
	axis_free(&u);
	axis_free(&v);
	return r;
}

int
resample_mean(Chart from, const double *f, Chart to, double *e)
{
	Axis u = { 0 }, v = { 0 };
	int r = mean_axis(&u, from.nu, to.nu) || mean_axis(&v, from.nv, to.nv);

	r = apply_both(&u, &v, r, from.nu, from.nv, f, e);
	axis_free(&u);
	axis_free(&v);
	return r;
}
