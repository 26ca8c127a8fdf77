/* curvematch.c - corresponding starting points of closed curves, by cross-correlation. */
#include <fftw3.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "curvematch.h"
#include "../base/procrustes.h"

static const double ROUNDING = 1e-13;   /* bound of the relative rounding error of norms - 2 gain */

/* Workspace and FFTW plans of one call of curvematch. */
typedef struct Correlation {
	int           n;
	double       *real;             /* [n] */
	double       *C;                /* [9][n] C_kl(s), row 3k + l */
	fftw_complex *f[2][3];          /* [n/2+1] transforms of the coordinates of both curves */
	fftw_complex *product;
	fftw_plan     forth, back;
} Correlation;

static void
correlation_free(Correlation *q)
{
	int k;

	for (k = 0; k < 6; k++)
		fftw_free(q->f[k/3][k%3]);
	fftw_free(q->product);
	fftw_free(q->real);
	free(q->C);
	if (q->forth)
		fftw_destroy_plan(q->forth);
	if (q->back)
		fftw_destroy_plan(q->back);
}

static int
correlation_init(Correlation *q, int n)
{
	int k, ok;

	*q = (Correlation){ .n = n, .real = fftw_alloc_real(n), .C = malloc(9*(size_t)n*sizeof(double)),
	    .product = fftw_alloc_complex(n/2 + 1) };
	ok = q->real && q->C && q->product;
	for (k = 0; k < 6; k++)
		ok = (q->f[k/3][k%3] = fftw_alloc_complex(n/2 + 1)) && ok;
	if (ok) {
		q->forth = fftw_plan_dft_r2c_1d(n, q->real, q->product, FFTW_ESTIMATE);
		q->back = fftw_plan_dft_c2r_1d(n, q->product, q->real, FFTW_ESTIMATE);
	}
	if (q->forth && q->back)
		return 0;
	correlation_free(q);
	return CURVEMATCH_ENOMEM;
}

/* Subtracts from each coordinate of a curve its mean, and sets f to the Fourier transforms.  Returns
 * the sum of the squares of the coordinates without their means. */
static double
transform(Correlation *q, const double *x, fftw_complex *f[3])
{
	double mean, sum = 0;
	int i, c;

	for (c = 0; c < 3; c++) {
		for (mean = 0, i = 0; i < q->n; i++)
			mean += x[3*i+c]/q->n;
		for (i = 0; i < q->n; i++) {
			q->real[i] = x[3*i+c] - mean;
			sum += q->real[i]*q->real[i];
		}
		fftw_execute_dft_r2c(q->forth, q->real, f[c]);
	}
	return sum;
}

/* Computes C_kl(s) = sum over i of a_k(i) b_l(i+s) for all s.  The transform of C_kl is
 * conj(A_k) B_l, where A and B are the transforms of a and b. */
static void
correlate(Correlation *q, int k, int l)
{
	const double (*a)[2] = (const double (*)[2])q->f[0][k], (*b)[2] = (const double (*)[2])q->f[1][l];
	int i;

	for (i = 0; i <= q->n/2; i++) {
		q->product[i][0] = a[i][0]*b[i][0] + a[i][1]*b[i][1];
		q->product[i][1] = a[i][0]*b[i][1] - a[i][1]*b[i][0];
	}
	fftw_execute_dft_c2r(q->back, q->product, q->real);
	for (i = 0; i < q->n; i++)
		q->C[(3*k + l)*(size_t)q->n + i] = q->real[i]/q->n;
}

static int
at_shift(const Correlation *q, int s, double norms, double *rms, double *angle)
{
	double C[3][3], gain;
	Rigid r;
	int k;

	for (k = 0; k < 9; k++)
		C[k/3][k%3] = q->C[k*(size_t)q->n + s];
	if (procrustes_rotation(C, r.R, &gain))
		return CURVEMATCH_EVALUE;
	*angle = rigid_angle(&r);
	*rms = norms - 2*gain > ROUNDING*norms ? sqrt((norms - 2*gain)/q->n) : 0;
	return 0;
}

int
curvematch(int n, const double *a, const double *b, double *rms, double *angle)
{
	double norms;
	Correlation q;
	int k, s, e;

	if ((e = correlation_init(&q, n)))
		return e;
	norms = transform(&q, a, q.f[0]) + transform(&q, b, q.f[1]);
	for (k = 0; k < 9; k++)
		correlate(&q, k/3, k%3);
	for (s = 0; s < n && !e; s++)
		e = at_shift(&q, s, norms, &rms[s], &angle[s]);
	correlation_free(&q);
	return e;
}

/* Whether shift s is a local minimum of rms. */
static int
is_local_minimum(int n, const double *rms, int s)
{
	return rms[s] <= rms[(s + 1)%n] && rms[s] <= rms[(s + n - 1)%n];
}

int
curvematch_choose(int n, const double *rms, const double *angle, double clear)
{
	int s, best = 0, chosen;

	for (s = 1; s < n; s++)
		if (rms[s] < rms[best])
			best = s;
	for (chosen = best, s = 0; s < n; s++)
		if (is_local_minimum(n, rms, s) && rms[s] <= clear*rms[best] && angle[s] < angle[chosen])
			chosen = s;
	return chosen;
}

double
curvematch_next(int n, const double *rms, int shift)
{
	double next = HUGE_VAL;
	int s;

	for (s = 0; s < n; s++)
		if (is_local_minimum(n, rms, s) && (s - shift + n)%n >= n/8 && (shift - s + n)%n >= n/8)
			next = fmin(next, rms[s]);
	return next;
}
