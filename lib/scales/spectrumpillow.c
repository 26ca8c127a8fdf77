/* spectrumpillow.c - the waves of a pillow, by FFTW on the grid itself.
 *
 * Exponentials along u: the coefficient of a row, turned to the middle between nodes 0 and nu-1, is
 *
 *   A_m = sum over i of f_i exp(-2 pi i m (i+1/2)/nu),
 *
 * and that of its image beyond a fold is conj(A_m).  So along v the real part is even, a sum of cosines, and the
 * imaginary part odd, a sum of sines. */
#include <math.h>
#include <string.h>

#include "spectrum.h"   /* with complex.h, which FFTW must see first */
#include "transformpriv.h"

#include <fftw3.h>

static int
pillow_columns(Chart g)
{
	return g.nu/2;
}

static int
pillow_rows(Chart g)
{
	return 2*g.nv;
}

static int
pillow_weight(Chart g, int m)
{
	(void)g, (void)m;
	return 1;
}

static int
is_sine(Chart g, size_t q)
{
	return q/(g.nu/2)%2;
}

static void
pillow_numbers(Chart g, size_t q, int *m, int *n)
{
	int sine = is_sine(g, q);

	*m = q%(g.nu/2) + sine;
	*n = q/(g.nu/2)/2 + sine;
}

static double
pillow_wave(Chart g, int m, int n)
{
	return hypot(m, n/(2*g.T));
}

/* c_mn of spectrum.h. */
static double
norm(Chart g, int m, int n)
{
	return (m % (g.nu/2) ? M_SQRT2 : 1)*(n % g.nv ? M_SQRT2 : 1);
}

/* The rows and their coefficients X; the real and the imaginary parts of A_m, [nv][nu/2] each.  Column k of `even` is m = k,
 * of `odd` m = k+1. */
typedef struct Parts {
	double         *x, *even, *odd;
	double complex *X;
	fftw_plan       along_u, cosines, sines;
} Parts;

static void
parts_free(Parts *d)
{
	if (d->along_u)
		fftw_destroy_plan(d->along_u);
	if (d->cosines)
		fftw_destroy_plan(d->cosines);
	if (d->sines)
		fftw_destroy_plan(d->sines);
	free(d->x);
	free(d->even);
	free(d->odd);
	free(d->X);
}

static int
parts_init(Parts *d, Chart g, int back)
{
	int n = g.nv, nu = g.nu, half = nu/2;
	size_t bytes = (size_t)n*half*sizeof(double);
	fftw_r2r_kind even = back ? FFTW_REDFT01 : FFTW_REDFT10, odd = back ? FFTW_RODFT01 : FFTW_RODFT10;

	*d = (Parts){ .x = waveform_aligned(2*bytes), .even = waveform_aligned(bytes), .odd = waveform_aligned(bytes),
	    .X = waveform_aligned((size_t)n*(half + 1)*sizeof *d->X) };
	if (d->x && d->even && d->odd && d->X) {
		d->along_u = back ? fftw_plan_many_dft_c2r(1, &nu, n, d->X, NULL, 1, half + 1, d->x, NULL, 1, nu,
		    FFTW_ESTIMATE) : fftw_plan_many_dft_r2c(1, &nu, n, d->x, NULL, 1, nu, d->X, NULL, 1, half + 1,
		    FFTW_ESTIMATE);
		d->cosines = fftw_plan_many_r2r(1, &n, half, d->even, NULL, half, 1, d->even, NULL, half, 1, &even,
		    FFTW_ESTIMATE);
		d->sines = fftw_plan_many_r2r(1, &n, half, d->odd, NULL, half, 1, d->odd, NULL, half, 1, &odd,
		    FFTW_ESTIMATE);
	}
	if (d->along_u && d->cosines && d->sines)
		return 0;
	parts_free(d);
	return SPECTRUM_ENOMEM;
}

/* exp(i pi m/nu), the turn from the nodes to the middle between them. */
static double complex
turn(Chart g, int m)
{
	return cexp(I*M_PI*m/g.nu);
}

static int
pillow_forward(Chart g, const double *f, double complex *C)
{
	int half = g.nu/2, j, k, m, n;
	size_t q, from;
	Parts d;

	if (parts_init(&d, g, 0))
		return SPECTRUM_ENOMEM;
	memcpy(d.x, f, (size_t)g.nu*g.nv*sizeof *f);
	fftw_execute(d.along_u);
	for (j = 0; j < g.nv; j++)
		for (k = 0; k < half; k++) {
			const double complex *X = d.X + (size_t)j*(half + 1) + k;

			d.even[(size_t)j*half + k] = creal(X[0]*conj(turn(g, k)));
			d.odd[(size_t)j*half + k] = -cimag(X[1]*conj(turn(g, k + 1)));
		}
	fftw_execute(d.cosines);
	fftw_execute(d.sines);
	for (q = 0; q < (size_t)g.nu*g.nv; q++) {
		pillow_numbers(g, q, &m, &n);
		from = q/half/2*half + q%half;
		C[q] = norm(g, m, n)*(is_sine(g, q) ? d.odd : d.even)[from]/2;  /* FFTW doubles the sum */
	}
	parts_free(&d);
	return 0;
}

static int
pillow_inverse(Chart g, const double complex *C, double *f)
{
	size_t nodes = (size_t)g.nu*g.nv, q;
	int half = g.nu/2, j, k, m, n;
	double share;
	Parts d;

	if (parts_init(&d, g, 1))
		return SPECTRUM_ENOMEM;
	for (q = 0; q < nodes; q++) {
		pillow_numbers(g, q, &m, &n);
		/* FFTW doubles all but the ends of the spectra */
		share = norm(g, m, n)/nodes/(m % half ? 2 : 1)/(n % g.nv ? 2 : 1);
		(is_sine(g, q) ? d.odd : d.even)[q/half/2*half + q%half] = share*creal(C[q]);
	}
	fftw_execute(d.cosines);
	fftw_execute(d.sines);
	for (j = 0; j < g.nv; j++)
		for (k = 0; k <= half; k++) {
			double re = k < half ? d.even[(size_t)j*half + k] : 0;
			double im = k > 0 ? d.odd[(size_t)j*half + k - 1] : 0;

			d.X[(size_t)j*(half + 1) + k] = (re - I*im)*turn(g, k);
		}
	fftw_execute(d.along_u);
	memcpy(f, d.x, nodes*sizeof *f);
	parts_free(&d);
	return 0;
}

const Waveform waveform_pillow = { pillow_columns, pillow_rows, pillow_weight, pillow_numbers, pillow_wave, pillow_forward,
    pillow_inverse };
