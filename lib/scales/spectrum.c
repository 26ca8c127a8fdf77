/* spectrum.c - cosine and Fourier transforms of a field, by FFTW. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "spectrum.h"   /* with complex.h, which FFTW must see first */
#include "transformpriv.h"

#include <fftw3.h>

/* ---- the rectangle: cosines ------------------------------------------ */

static int
all_rows(Chart g)
{
	return g.nv;
}

static int
dct_columns(Chart g)
{
	return g.nu;
}

static int
dct_weight(Chart g, int m)
{
	(void)g, (void)m;
	return 1;
}

static void
dct_numbers(Chart g, size_t q, int *m, int *n)
{
	*m = q%g.nu;
	*n = q/g.nu;
}

static double
dct_wave(Chart g, int m, int n)
{
	return hypot(m/(2*g.nu*chart_h(g)), n/(2*g.nv*chart_k(g)));
}

/* FFTW's REDFT10 computes 4 sum f cos cos.  So C_mn = e_m e_n REDFT10, where e_0 = 1/2 and all
 * other e_k = 1/sqrt 2. */
static double
dct_norm(Chart g, size_t q)
{
	return (q%g.nu ? sqrt(0.5) : 0.5)*(q/g.nu ? sqrt(0.5) : 0.5);
}

/* Transforms x[nv][nu] in place. */
static void
dct_execute(Chart g, double *x, const double *from, fftw_r2r_kind kind)
{
	fftw_plan plan = fftw_plan_r2r_2d(g.nv, g.nu, x, x, kind, kind, FFTW_ESTIMATE);

	if (from)
		memcpy(x, from, (size_t)g.nu*g.nv*sizeof *x);
	fftw_execute(plan);
	fftw_destroy_plan(plan);
}

static int
dct_forward(Chart g, const double *f, double complex *C)
{
	size_t n = (size_t)g.nu*g.nv, q;
	double *x = waveform_aligned(n*sizeof *x);

	if (!x)
		return SPECTRUM_ENOMEM;
	dct_execute(g, x, f, FFTW_REDFT10);
	for (q = 0; q < n; q++)
		C[q] = dct_norm(g, q)*x[q];
	free(x);
	return 0;
}

static int
dct_inverse(Chart g, const double complex *C, double *f)
{
	size_t n = (size_t)g.nu*g.nv, q;
	double *x = waveform_aligned(n*sizeof *x);
	fftw_plan plan;

	if (!x)
		return SPECTRUM_ENOMEM;
	plan = fftw_plan_r2r_2d(g.nv, g.nu, x, x, FFTW_REDFT01, FFTW_REDFT01, FFTW_ESTIMATE);
	for (q = 0; q < n; q++)
		x[q] = creal(C[q])/dct_norm(g, q)/4;    /* REDFT01 inverts REDFT10 up to a factor 4 n */
	fftw_execute(plan);
	fftw_destroy_plan(plan);
	for (q = 0; q < n; q++)
		f[q] = x[q]/n;
	free(x);
	return 0;
}

static const Waveform dct = { dct_columns, all_rows, dct_weight, dct_numbers, dct_wave, dct_forward, dct_inverse };

/* ---- the rectangle: exponentials ------------------------------------- */

static int
dft_columns(Chart g)
{
	return g.nu/2 + 1;
}

static int
dft_weight(Chart g, int m)
{
	return m == 0 || 2*m == g.nu ? 1 : 2;
}

static void
dft_numbers(Chart g, size_t q, int *m, int *n)
{
	*m = q%dft_columns(g);
	*n = q/dft_columns(g);
	if (2**n > g.nv)
		*n -= g.nv;
}

static double
dft_wave(Chart g, int m, int n)
{
	return hypot(m/(g.nu*chart_h(g)), n/(g.nv*chart_k(g)));
}

static int
dft_forward(Chart g, const double *f, double complex *C)
{
	size_t n = (size_t)g.nu*g.nv, size = (size_t)dft_columns(g)*g.nv;
	double *in = waveform_aligned(n*sizeof *in);
	double complex *out = waveform_aligned(size*sizeof *out);
	fftw_plan plan;

	if (in && out) {
		plan = fftw_plan_dft_r2c_2d(g.nv, g.nu, in, out, FFTW_ESTIMATE);
		memcpy(in, f, n*sizeof *in);
		fftw_execute(plan);                                     /* (16), (17) */
		fftw_destroy_plan(plan);
		memcpy(C, out, size*sizeof *C);
	}
	n = in && out;
	free(in);
	free(out);
	return n ? 0 : SPECTRUM_ENOMEM;
}

static int
dft_inverse(Chart g, const double complex *C, double *f)
{
	size_t n = (size_t)g.nu*g.nv, size = (size_t)dft_columns(g)*g.nv, q;
	double complex *in = waveform_aligned(size*sizeof *in);
	double *out = waveform_aligned(n*sizeof *out);
	fftw_plan plan;

	if (in && out) {
		plan = fftw_plan_dft_c2r_2d(g.nv, g.nu, in, out, FFTW_ESTIMATE);
		memcpy(in, C, size*sizeof *in);
		fftw_execute(plan);                                     /* (18), (19) */
		fftw_destroy_plan(plan);
		for (q = 0; q < n; q++)
			f[q] = out[q]/n;
	}
	n = in && out;
	free(in);
	free(out);
	return n ? 0 : SPECTRUM_ENOMEM;
}

static const Waveform dft = { dft_columns, all_rows, dft_weight, dft_numbers, dft_wave, dft_forward, dft_inverse };

/* ---- any chart ------------------------------------------------------- */

static const struct {
	SpectrumBasis    basis;
	const ChartKind *kind;
	const Waveform  *waveform;
} known[] = {
	{ SPECTRUM_DCT, &CHART_RECTANGLE, &dct },
	{ SPECTRUM_DFT, &CHART_RECTANGLE, &dft },
	{ SPECTRUM_DCT, &CHART_SOCK, &waveform_fold },
	{ SPECTRUM_DCT, &CHART_PILLOW, &waveform_pillow },
};

static const Waveform *
waveform(Spectrum s)
{
	size_t i;

	for (i = 0; i < sizeof known/sizeof *known; i++)
		if (known[i].basis == s.basis && known[i].kind == s.g.kind)
			return known[i].waveform;
	return NULL;
}

int
spectrum_exists(Spectrum s)
{
	return waveform(s) != NULL;
}

int
spectrum_columns(Spectrum s)
{
	return waveform(s)->columns(s.g);
}

int
spectrum_weight(Spectrum s, int m)
{
	return waveform(s)->weight(s.g, m);
}

size_t
spectrum_size(Spectrum s)
{
	return (size_t)waveform(s)->columns(s.g)*waveform(s)->rows(s.g);
}

void
spectrum_numbers(Spectrum s, size_t q, int *m, int *n)
{
	waveform(s)->numbers(s.g, q, m, n);
}

double
spectrum_wave(Spectrum s, size_t q)
{
	int m, n;

	spectrum_numbers(s, q, &m, &n);
	return waveform(s)->wave(s.g, m, n);
}

int
spectrum_forward(Spectrum s, const double *f, double complex *C)
{
	return waveform(s)->forward(s.g, f, C);
}

int
spectrum_inverse(Spectrum s, const double complex *C, double *f)
{
	return waveform(s)->inverse(s.g, C, f);
}

void
spectrum_moduli(Spectrum s, const double complex *C, double *a)
{
	int m, n, twin, cols = spectrum_columns(s), rows = waveform(s)->rows(s.g);

	for (n = 0; n < rows; n++)
		for (m = 0; m < cols; m++) {
			twin = s.basis == SPECTRUM_DFT && spectrum_weight(s, m) == 1 && 2*n > rows ? rows - n : n;
			a[(size_t)n*cols + m] = cabs(C[(size_t)twin*cols + m]);
		}
}
