/* outline.c - the outline of a ragged closed curve. */
#include <fftw3.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "outline.h"

static const double WAVES = 8;          /* a wave with this many periods is damped to 1/e */

/* Sets s[i] to the arc length of the closed polygon x from its start to point i, 0 .. n. */
static int
arc_lengths(int n, const double *x, double *s)
{
	const double *p, *q;
	int i;

	s[0] = 0;
	for (i = 0; i < n; i++) {
		p = x + 3*i;
		q = x + 3*((i + 1)%n);
		s[i+1] = s[i] + hypot(hypot(q[0] - p[0], q[1] - p[1]), q[2] - p[2]);
	}
	return s[n] > 0 && s[n] < HUGE_VAL ? 0 : OUTLINE_EVALUE;
}

/* Sets y to n points at equal distances in arc length on the closed polygon x[m].  s are its arc
 * lengths, from arc_lengths. */
static void
equal_points(int m, const double *x, const double *s, int n, double *y)
{
	double a, w;
	int i = 0, k, c;

	for (k = 0; k < n; k++) {
		a = k*(s[m]/n);
		while (i < m - 1 && s[i+1] <= a)
			i++;
		w = s[i+1] > s[i] ? fmin((a - s[i])/(s[i+1] - s[i]), 1) : 0;
		for (c = 0; c < 3; c++)
			y[3*k+c] = (1 - w)*x[3*i+c] + w*x[3*((i + 1)%m)+c];
	}
}

/* Smooths each coordinate of x and divides it by unit, to avoid overflow. */
static int
smooth(int n, double *x, double unit)
{
	double *f = fftw_alloc_real(n), factor;
	fftw_complex *F = fftw_alloc_complex(n/2 + 1);
	fftw_plan forth = f && F ? fftw_plan_dft_r2c_1d(n, f, F, FFTW_ESTIMATE) : NULL;
	fftw_plan back = f && F ? fftw_plan_dft_c2r_1d(n, F, f, FFTW_ESTIMATE) : NULL;
	int i, c;

	for (c = 0; forth && back && c < 3; c++) {
		for (i = 0; i < n; i++)
			f[i] = x[3*i+c]/unit;
		fftw_execute(forth);
		for (i = 0; i <= n/2; i++) {
			factor = i ? exp(-(i/WAVES)*(i/WAVES))/n : 0;           /* i = 0: the mean */
			F[i][0] *= factor;
			F[i][1] *= factor;
		}
		fftw_execute(back);
		for (i = 0; i < n; i++)
			x[3*i+c] = f[i];
	}
	c = forth && back ? 0 : OUTLINE_ENOMEM;
	if (forth)
		fftw_destroy_plan(forth);
	if (back)
		fftw_destroy_plan(back);
	fftw_free(f);
	fftw_free(F);
	return c;
}

/* Moves and scales x to mean 0 and root mean square 1. */
static int
standardise(int n, double *x)
{
	double mean[3] = { 0 }, sum = 0;
	int i;

	for (i = 0; i < 3*n; i++)
		mean[i%3] += x[i]/n;
	for (i = 0; i < 3*n; i++) {
		x[i] -= mean[i%3];
		sum += x[i]*x[i]/n;
	}
	for (i = 0; i < 3*n; i++)
		x[i] /= sqrt(sum);
	return sum > 0 && sum < HUGE_VAL ? 0 : OUTLINE_EVALUE;
}

int
outline_init(Outline *o, int n, int m, const double *x)
{
	double *s = malloc((m + 1)*sizeof *s), *y = malloc(3*(size_t)n*sizeof *y);
	int e = OUTLINE_ENOMEM, k;

	*o = (Outline){ n, malloc(3*(size_t)n*sizeof *x), malloc((n + 1)*sizeof *x) };
	if (s && y && o->x && o->place)
		e = arc_lengths(m, x, s);
	if (!e) {
		equal_points(m, x, s, n, y);
		e = smooth(n, y, s[m]);
	}
	if (!e)
		e = arc_lengths(n, y, o->place);
	if (!e) {
		equal_points(n, y, o->place, n, o->x);
		for (k = 0; k < n; k++)
			o->place[k] /= o->place[n];
		o->place[n] = 1;
		e = standardise(n, o->x);
	}
	free(s);
	free(y);
	if (e)
		outline_free(o);
	return e;
}

void
outline_free(Outline *o)
{
	free(o->x);
	free(o->place);
	memset(o, 0, sizeof *o);
}

double
outline_place(const Outline *o, double place)
{
	int k = (int)fmin(floor(place*o->n), o->n - 1);
	double w = place*o->n - k;

	return (1 - w)*o->place[k] + w*o->place[k+1];
}

double
outline_back(const Outline *o, double place)
{
	int lo = 0, hi = o->n, mid;
	double w;

	while (hi - lo > 1)
		if (o->place[mid = (lo + hi)/2] <= place)
			lo = mid;
		else
			hi = mid;
	w = o->place[hi] > o->place[lo] ? (place - o->place[lo])/(o->place[hi] - o->place[lo]) : 0;
	return (lo + w)/o->n;
}
