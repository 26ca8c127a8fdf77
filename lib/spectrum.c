/* spectrum.c - FFTW behind spectrum.h. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "spectrum.h"   /* with complex.h, which FFTW must see first */

#include <fftw3.h>

/* Alike at every run: FFTW's plan depends on alignment. */
static void *
aligned(size_t bytes)
{
	return aligned_alloc(64, (bytes + 63)/64*64);
}

static size_t
columns(int nu)
{
	return nu/2 + 1;
}

int
spectrum_forward(int nu, int nv, const double *f, double complex *C)
{
	size_t n = (size_t)nu*nv, half = columns(nu)*nv;
	double *in = aligned(n*sizeof *in);
	double complex *out = aligned(half*sizeof *out);
	fftw_plan plan;

	if (!in || !out) {
		free(in);
		free(out);
		return SPECTRUM_ENOMEM;
	}
	plan = fftw_plan_dft_r2c_2d(nv, nu, in, out, FFTW_ESTIMATE);
	memcpy(in, f, n*sizeof *in);
	fftw_execute(plan);
	fftw_destroy_plan(plan);
	memcpy(C, out, half*sizeof *out);
	free(in);
	free(out);
	return 0;
}

int
spectrum_inverse(int nu, int nv, const double complex *C, double *f)
{
	size_t n = (size_t)nu*nv, half = columns(nu)*nv, p;
	double complex *in = aligned(half*sizeof *in);
	double *out = aligned(n*sizeof *out);
	fftw_plan plan;

	if (!in || !out) {
		free(in);
		free(out);
		return SPECTRUM_ENOMEM;
	}
	plan = fftw_plan_dft_c2r_2d(nv, nu, in, out, FFTW_ESTIMATE);
	memcpy(in, C, half*sizeof *in);
	fftw_execute(plan);
	fftw_destroy_plan(plan);
	for (p = 0; p < n; p++)
		f[p] = out[p]/n;
	free(in);
	free(out);
	return 0;
}

/* How many of the nu nv coefficients column m of the half stands for. */
static int
weight(int nu, size_t m)
{
	return m == 0 || 2*m == (size_t)nu ? 1 : 2;
}

typedef struct Ranked {
	double modulus;
	size_t q;
} Ranked;

static int
larger_first(const void *a, const void *b)
{
	const Ranked *x = a, *y = b;

	if (x->modulus != y->modulus)
		return x->modulus < y->modulus ? 1 : -1;
	return x->q > y->q ? 1 : -1;
}

/* The modulus of the last coefficient that `count` keeps; those above or equal stay.
 * Conjugate pairs inside the columns 0 and nu/2 have equal moduli and so stay together. */
static int
modulus_of_rank(int nu, int nv, const double complex *C, double count, double *modulus)
{
	size_t half = columns(nu)*nv, q;
	Ranked *r = malloc(half*sizeof *r);
	double sum = 0;

	if (!r)
		return SPECTRUM_ENOMEM;
	for (q = 0; q < half; q++)
		r[q] = (Ranked){ q ? cabs(C[q]) : HUGE_VAL, q };
	qsort(r, half, sizeof *r, larger_first);
	for (q = 0; q < half && sum < count; q++)
		sum += weight(nu, r[q].q%columns(nu));
	*modulus = q ? r[q-1].modulus : HUGE_VAL;
	free(r);
	return 0;
}

static double
root_mean_square(size_t n, const double *f)
{
	double sum = 0;
	size_t p;

	for (p = 0; p < n; p++)
		sum += f[p]*f[p];
	return sqrt(sum/n);
}

/* Drops what is not above the bound (rule KEEP: below it); returns how many stay. */
static size_t
drop(int nu, int nv, double complex *C, double bound, int keep_equal)
{
	size_t half = columns(nu)*nv, q, kept = 0;
	double modulus;

	for (q = 0; q < half; q++) {
		modulus = cabs(C[q]);
		if (q == 0 || modulus > bound || (keep_equal && modulus == bound))
			kept += weight(nu, q%columns(nu));
		else
			C[q] = 0;                                       /* (32) */
	}
	return kept;
}

int
spectrum_filter(int nu, int nv, double *f, SpectrumRule rule, double bound, size_t *kept)
{
	size_t n = (size_t)nu*nv;
	double complex *C = malloc(columns(nu)*nv*sizeof *C);
	int e = C ? spectrum_forward(nu, nv, f, C) : SPECTRUM_ENOMEM;

	if (!e && rule == SPECTRUM_PERCENT)
		bound *= n*root_mean_square(n, f)/100;
	if (!e && rule == SPECTRUM_KEEP)
		e = modulus_of_rank(nu, nv, C, bound, &bound);
	if (!e) {
		*kept = drop(nu, nv, C, bound, rule == SPECTRUM_KEEP);
		if (*kept < n)
			e = spectrum_inverse(nu, nv, C, f);
	}
	free(C);
	return e;
}
