/* spectrum.c - cosine and Fourier transforms of a field, by FFTW. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "spectrum.h"   /* with complex.h, which FFTW must see first */

#include <fftw3.h>

/* Memory with a fixed alignment.  FFTW's plan depends on the alignment, so it is the same in all
 * runs. */
static void *
aligned(size_t bytes)
{
	return aligned_alloc(64, (bytes + 63)/64*64);
}

int
spectrum_columns(Spectrum s)
{
	return s.basis == SPECTRUM_DCT ? s.g.nu : s.g.nu/2 + 1;
}

int
spectrum_weight(Spectrum s, int m)
{
	return s.basis == SPECTRUM_DCT || m == 0 || 2*m == s.g.nu ? 1 : 2;
}

size_t
spectrum_size(Spectrum s)
{
	return (size_t)spectrum_columns(s)*s.g.nv;
}

double
spectrum_wave(Spectrum s, size_t q)
{
	int m = q%spectrum_columns(s), n = q/spectrum_columns(s), half = s.basis == SPECTRUM_DCT ? 2 : 1;

	if (s.basis == SPECTRUM_DFT && 2*n > s.g.nv)
		n -= s.g.nv;
	return hypot(m/(half*s.g.nu*chart_h(s.g)), n/(half*s.g.nv*chart_k(s.g)));
}

/* FFTW's REDFT10 computes 4 sum f cos cos.  So C_mn = e_m e_n REDFT10, where e_0 = 1/2 and all
 * other e_k = 1/sqrt 2. */
static double
dct_norm(Spectrum s, size_t q)
{
	return (q%s.g.nu ? sqrt(0.5) : 0.5)*(q/s.g.nu ? sqrt(0.5) : 0.5);
}

static fftw_plan
dct_plan(Spectrum s, double *in, double *out, fftw_r2r_kind kind)
{
	return fftw_plan_r2r_2d(s.g.nv, s.g.nu, in, out, kind, kind, FFTW_ESTIMATE);
}

int
spectrum_forward(Spectrum s, const double *f, double complex *C)
{
	size_t n = (size_t)s.g.nu*s.g.nv, q;
	double *in = aligned(n*sizeof *in);
	double complex *out = aligned(spectrum_size(s)*sizeof *out);
	fftw_plan plan;

	if (!in || !out) {
		free(in);
		free(out);
		return SPECTRUM_ENOMEM;
	}
	if (s.basis == SPECTRUM_DCT)
		plan = dct_plan(s, in, in, FFTW_REDFT10);
	else
		plan = fftw_plan_dft_r2c_2d(s.g.nv, s.g.nu, in, out, FFTW_ESTIMATE);
	memcpy(in, f, n*sizeof *in);
	fftw_execute(plan);                                             /* (16), (17) */
	fftw_destroy_plan(plan);
	for (q = 0; q < spectrum_size(s); q++)
		C[q] = s.basis == SPECTRUM_DCT ? dct_norm(s, q)*in[q] : out[q];
	free(in);
	free(out);
	return 0;
}

int
spectrum_inverse(Spectrum s, const double complex *C, double *f)
{
	size_t n = (size_t)s.g.nu*s.g.nv, q;
	double complex *in = aligned(spectrum_size(s)*sizeof *in);
	double *out = aligned(n*sizeof *out);
	fftw_plan plan;
	int dct = s.basis == SPECTRUM_DCT;

	if (!in || !out) {
		free(in);
		free(out);
		return SPECTRUM_ENOMEM;
	}
	if (dct)
		plan = dct_plan(s, out, out, FFTW_REDFT01);     /* inverts REDFT10 up to a factor 4 n */
	else
		plan = fftw_plan_dft_c2r_2d(s.g.nv, s.g.nu, in, out, FFTW_ESTIMATE);
	for (q = 0; q < spectrum_size(s); q++)
		if (dct)
			out[q] = creal(C[q])/dct_norm(s, q)/4;
		else
			in[q] = C[q];
	fftw_execute(plan);                                             /* (18), (19) */
	fftw_destroy_plan(plan);
	for (q = 0; q < n; q++)
		f[q] = out[q]/n;
	free(in);
	free(out);
	return 0;
}

void
spectrum_moduli(Spectrum s, const double complex *C, double *a)
{
	int m, n, twin, cols = spectrum_columns(s);

	for (n = 0; n < s.g.nv; n++)
		for (m = 0; m < cols; m++) {
			twin = s.basis == SPECTRUM_DFT && spectrum_weight(s, m) == 1 && 2*n > s.g.nv ? s.g.nv - n : n;
			a[(size_t)n*cols + m] = cabs(C[(size_t)twin*cols + m]);
		}
}
