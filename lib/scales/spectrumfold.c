/* spectrumfold.c - the waves of a sock that are the same on both sheets, by FFTW on the doubled grid.
 *
 * The doubled grid has 2 nv rows, v = -T to T.  Cosines along v, then exponentials along u: for even n the
 * coefficients, turned to the middle between nodes, are real, the sums of f cos cos; for odd n they are
 * imaginary, the sums of f sin cos. */
#include <math.h>
#include <string.h>

#include "spectrum.h"   /* with complex.h, which FFTW must see first */
#include "transformpriv.h"

#include <fftw3.h>

static int
fold_columns(Chart g)
{
	return g.nu/2;
}

static int
fold_rows(Chart g)
{
	return 2*g.nv;
}

static int
fold_weight(Chart g, int m)
{
	(void)g, (void)m;
	return 1;
}

static void
fold_numbers(Chart g, size_t q, int *m, int *n)
{
	*n = q/(g.nu/2);
	*m = q%(g.nu/2) + *n%2;
}

static double
fold_wave(Chart g, int m, int n)
{
	return hypot(m, n/(4*g.nv*chart_k(g)));
}

/* c_mn of spectrum.h. */
static double
norm(Chart g, int m, int n)
{
	return (m % (g.nu/2) ? M_SQRT2 : 1)*(n ? M_SQRT2 : 1);
}

/* The doubled grid, its half spectrum along u, and the plans between them. */
typedef struct Double {
	double         *x;
	double complex *X;
	fftw_plan       along_v, along_u;
} Double;

static void
double_free(Double *d)
{
	if (d->along_v)
		fftw_destroy_plan(d->along_v);
	if (d->along_u)
		fftw_destroy_plan(d->along_u);
	free(d->x);
	free(d->X);
}

static int
double_init(Double *d, Chart g, int back)
{
	int n = 2*g.nv, nu = g.nu, half = nu/2 + 1;
	fftw_r2r_kind kind = back ? FFTW_REDFT01 : FFTW_REDFT10;

	*d = (Double){ waveform_aligned((size_t)n*nu*sizeof *d->x), waveform_aligned((size_t)n*half*sizeof *d->X),
	    NULL, NULL };
	if (d->x && d->X) {
		d->along_v = fftw_plan_many_r2r(1, &n, nu, d->x, NULL, nu, 1, d->x, NULL, nu, 1, &kind, FFTW_ESTIMATE);
		d->along_u = back ? fftw_plan_many_dft_c2r(1, &nu, n, d->X, NULL, 1, half, d->x, NULL, 1, nu,
		    FFTW_ESTIMATE) : fftw_plan_many_dft_r2c(1, &nu, n, d->x, NULL, 1, nu, d->X, NULL, 1, half,
		    FFTW_ESTIMATE);
	}
	if (d->along_v && d->along_u)
		return 0;
	double_free(d);
	return SPECTRUM_ENOMEM;
}

/* exp(i pi m/nu), the turn from the nodes to the middle between them; for odd n divided by i, so that
 * what is left is real. */
static double complex
turn(Chart g, int m, int n)
{
	return cexp(I*M_PI*m/g.nu)/(n%2 ? I : 1);
}

static int
fold_forward(Chart g, const double *f, double complex *C)
{
	size_t nodes = (size_t)g.nu*g.nv, p;
	int half = g.nu/2 + 1, m, n;
	Double d;

	if (double_init(&d, g, 0))
		return SPECTRUM_ENOMEM;
	for (p = 0; p < nodes; p++)
		d.x[nodes+p] = d.x[nodes-1-p] = f[p];
	fftw_execute(d.along_v);
	fftw_execute(d.along_u);
	for (p = 0; p < nodes; p++) {
		fold_numbers(g, p, &m, &n);
		/* REDFT10 and the two sheets double the sum */
		C[p] = norm(g, m, n)*creal(d.X[(size_t)n*half + m]*conj(turn(g, m, n)))/4;
	}
	double_free(&d);
	return 0;
}

static int
fold_inverse(Chart g, const double complex *C, double *f)
{
	size_t nodes = (size_t)g.nu*g.nv, p;
	int half = g.nu/2 + 1, m, n;
	double share;
	Double d;

	if (double_init(&d, g, 1))
		return SPECTRUM_ENOMEM;
	memset(d.X, 0, 2*(size_t)g.nv*half*sizeof *d.X);
	for (p = 0; p < nodes; p++) {
		fold_numbers(g, p, &m, &n);
		/* FFTW doubles all but the ends of the spectra */
		share = norm(g, m, n)/nodes/(m % (g.nu/2) ? 2 : 1)/(n ? 2 : 1);
		d.X[(size_t)n*half + m] = share*creal(C[p])*turn(g, m, n);
	}
	fftw_execute(d.along_u);
	fftw_execute(d.along_v);
	memcpy(f, d.x + nodes, nodes*sizeof *f);
	double_free(&d);
	return 0;
}

const Waveform waveform_fold = { fold_columns, fold_rows, fold_weight, fold_numbers, fold_wave, fold_forward,
    fold_inverse };
