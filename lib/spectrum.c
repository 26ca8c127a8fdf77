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

int
spectrum_columns(Spectrum s)
{
	return s.basis == SPECTRUM_DCT ? s.nu : s.nu/2 + 1;
}

int
spectrum_weight(Spectrum s, int m)
{
	return s.basis == SPECTRUM_DCT || m == 0 || 2*m == s.nu ? 1 : 2;
}

static size_t
nodes(Spectrum s)
{
	return (size_t)s.nu*s.nv;
}

static size_t
size(Spectrum s)
{
	return (size_t)spectrum_columns(s)*s.nv;
}

/* FFTW's REDFT10 is 4 sum f cos cos: C = e_m e_n of it, e_0 = 1/2, other e = 1/sqrt 2. */
static double
dct_norm(Spectrum s, size_t q)
{
	return (q%s.nu ? sqrt(0.5) : 0.5)*(q/s.nu ? sqrt(0.5) : 0.5);
}

static fftw_plan
dct_plan(Spectrum s, double *in, double *out, fftw_r2r_kind kind)
{
	return fftw_plan_r2r_2d(s.nv, s.nu, in, out, kind, kind, FFTW_ESTIMATE);
}

int
spectrum_forward(Spectrum s, const double *f, double complex *C)
{
	size_t n = nodes(s), q;
	double *in = aligned(n*sizeof *in);
	double complex *out = aligned(size(s)*sizeof *out);
	fftw_plan plan;

	if (!in || !out) {
		free(in);
		free(out);
		return SPECTRUM_ENOMEM;
	}
	if (s.basis == SPECTRUM_DCT)
		plan = dct_plan(s, in, in, FFTW_REDFT10);
	else
		plan = fftw_plan_dft_r2c_2d(s.nv, s.nu, in, out, FFTW_ESTIMATE);
	memcpy(in, f, n*sizeof *in);
	fftw_execute(plan);
	fftw_destroy_plan(plan);
	for (q = 0; q < size(s); q++)
		C[q] = s.basis == SPECTRUM_DCT ? dct_norm(s, q)*in[q] : out[q];
	free(in);
	free(out);
	return 0;
}

int
spectrum_inverse(Spectrum s, const double complex *C, double *f)
{
	size_t n = nodes(s), q;
	double complex *in = aligned(size(s)*sizeof *in);
	double *out = aligned(n*sizeof *out);
	fftw_plan plan;
	int dct = s.basis == SPECTRUM_DCT;

	if (!in || !out) {
		free(in);
		free(out);
		return SPECTRUM_ENOMEM;
	}
	if (dct)
		plan = dct_plan(s, out, out, FFTW_REDFT01);     /* of REDFT10: 4 n f */
	else
		plan = fftw_plan_dft_c2r_2d(s.nv, s.nu, in, out, FFTW_ESTIMATE);
	for (q = 0; q < size(s); q++)
		if (dct)
			out[q] = creal(C[q])/dct_norm(s, q)/4;
		else
			in[q] = C[q];
	fftw_execute(plan);
	fftw_destroy_plan(plan);
	for (q = 0; q < n; q++)
		f[q] = out[q]/n;
	free(in);
	free(out);
	return 0;
}

/* |C|.  Conjugates held both, in the columns 0 and nu/2 of the dft, are given one modulus,
 * not two apart by rounding, and so stay together. */
static void
moduli(Spectrum s, const double complex *C, double *a)
{
	int m, n, twin, cols = spectrum_columns(s);

	for (n = 0; n < s.nv; n++)
		for (m = 0; m < cols; m++) {
			twin = s.basis == SPECTRUM_DFT && spectrum_weight(s, m) == 1 && 2*n > s.nv ? s.nv - n : n;
			a[(size_t)n*cols + m] = cabs(C[(size_t)twin*cols + m]);
		}
}

typedef struct Ranked {
	double a;
	size_t q;
} Ranked;

static int
larger_first(const void *x, const void *y)
{
	const Ranked *r = x, *t = y;

	if (r->a != t->a)
		return r->a < t->a ? 1 : -1;
	return r->q > t->q ? 1 : -1;
}

/* The modulus of the last coefficient that `count` keeps. */
static int
modulus_of_rank(Spectrum s, const double *a, double count, double *bound)
{
	Ranked *r = malloc(size(s)*sizeof *r);
	size_t q;
	double sum = 0;

	if (!r)
		return SPECTRUM_ENOMEM;
	for (q = 0; q < size(s); q++)
		r[q] = (Ranked){ q ? a[q] : HUGE_VAL, q };
	qsort(r, size(s), sizeof *r, larger_first);
	for (q = 0; q < size(s) && sum < count; q++)
		sum += spectrum_weight(s, r[q].q%spectrum_columns(s));
	*bound = q ? r[q-1].a : HUGE_VAL;
	free(r);
	return 0;
}

/* The root mean square of f minus `from`. */
static double
root_mean_square(size_t n, const double *f, double from)
{
	double sum = 0;
	size_t p;

	for (p = 0; p < n; p++)
		sum += (f[p] - from)*(f[p] - from);
	return sqrt(sum/n);
}

/* Drops what is not above the bound (rule KEEP: below it).  Returns whether any of it was
 * not zero. */
static int
drop(Spectrum s, double complex *C, const double *a, double bound, int keep_equal, size_t *kept)
{
	size_t q;
	int changed = 0;

	for (*kept = q = 0; q < size(s); q++)
		if (q == 0 || a[q] > bound || (keep_equal && a[q] == bound))
			*kept += spectrum_weight(s, q%spectrum_columns(s));
		else {
			changed |= C[q] != 0;
			C[q] = 0;                                       /* (32) */
		}
	return changed;
}

/* Filters x, that is f or log f; *changed 0: x is not worth reading. */
static int
filter(Spectrum s, const SpectrumFilter *by, double *x, double complex *C, double *a, size_t *kept, int *changed)
{
	size_t n = nodes(s);
	double bound = by->bound;
	int e = spectrum_forward(s, x, C);

	if (e)
		return e;
	moduli(s, C, a);
	if (by->rule == SPECTRUM_PERCENT)
		bound *= n*root_mean_square(n, x, by->log ? creal(C[0])/n : 0)/100;
	if (by->rule == SPECTRUM_KEEP)
		e = modulus_of_rank(s, a, bound, &bound);
	if (e)
		return e;
	*changed = drop(s, C, a, bound, by->rule == SPECTRUM_KEEP, kept);
	return *changed ? spectrum_inverse(s, C, x) : 0;
}

int
spectrum_filter(Spectrum s, const SpectrumFilter *by, double *f, size_t *kept)
{
	size_t n = nodes(s), p;
	double *x = malloc(n*sizeof *x), *a = malloc(size(s)*sizeof *a);
	double complex *C = malloc(size(s)*sizeof *C);
	int changed = 0, e = SPECTRUM_ENOMEM;

	for (p = 0; p < n && x; p++)
		x[p] = by->log ? log(f[p]) : f[p];
	if (x && a && C)
		e = filter(s, by, x, C, a, kept, &changed);
	for (p = 0; p < n && !e && changed; p++)
		f[p] = by->log ? exp(x[p]) : x[p];
	free(x);
	free(a);
	free(C);
	return e;
}
