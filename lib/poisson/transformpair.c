/* transformpair.c - sine and cosine transforms of two lines by one complex Fourier transform.
 *
 * With y and x real and Y the transform of y + i x, those of y and x are (Y_k + conj Y_N-k)/2 and
 * (Y_k - conj Y_N-k)/(2 i).
 */
#include "transform.h"

/* The index in the workspace where the spectrum begins: after N complex numbers, rounded up for
 * alignment. */
static size_t
spectrum_offset(int N)
{
	return (2*(size_t)N + 7)/8*8;
}

size_t
transform_pair_room(const Transform *t)
{
	return 2*spectrum_offset(t->N);
}

int
transform_init_pair(Transform *t)
{
	double *work = fftw_alloc_real(transform_pair_room(t));

	if (work)
		t->pair = fftw_plan_dft_1d(t->N, (fftw_complex *)work, (fftw_complex *)(work + spectrum_offset(t->N)),
		    FFTW_FORWARD, FFTW_ESTIMATE);
	fftw_free(work);
	return t->pair ? 0 : TRANSFORM_ENOMEM;
}

/* The coefficients number k, 0 < k < N, of both lines: R - iI. */
typedef struct Both {
	double R[2], I[2];
} Both;

static Both
both(fftw_complex *Y, int N, int k)
{
	return (Both){ { (Y[k][0] + Y[N-k][0])/2, (Y[k][1] + Y[N-k][1])/2 },
	    { (Y[N-k][1] - Y[k][1])/2, (Y[k][0] - Y[N-k][0])/2 } };
}

/* The formulas are those of transform.c. */
void
transform_sine_pair(const Transform *t, double *f, double *g, double *work)
{
	int N = t->N, j, k, l;
	fftw_complex *y = (fftw_complex *)work, *Y = (fftw_complex *)(work + spectrum_offset(N));
	double *line[2] = { f, g }, sum[2];

	y[0][0] = y[0][1] = 0;
	for (j = 1; j < N; j++)
		for (l = 0; l < 2; l++) {
			double a = line[l][j-1], b = line[l][N-j-1];

			y[j][l] = t->sines[j]*(a + b) + (a - b)/2;
		}
	fftw_execute_dft(t->pair, y, Y);
	for (l = 0; l < 2; l++)
		line[l][0] = sum[l] = Y[0][l]/2;
	for (k = 1; 2*k < N; k++) {
		Both c = both(Y, N, k);

		for (l = 0; l < 2; l++) {
			line[l][2*k-1] = c.I[l];
			sum[l] += c.R[l];
			if (2*k < N - 1)
				line[l][2*k] = sum[l];
		}
	}
}

void
transform_cosine_pair(const Transform *t, double *f, double *g, double *work)
{
	int N = t->N, j, k, l;
	fftw_complex *y = (fftw_complex *)work, *Y = (fftw_complex *)(work + spectrum_offset(N));
	double *line[2] = { f, g }, sum[2];

	for (l = 0; l < 2; l++) {
		double *x = line[l];

		sum[l] = (x[0] - x[N])/2;
		y[0][l] = (x[0] + x[N])/2;
		for (j = 1; j < N; j++) {
			y[j][l] = (x[j] + x[N-j])/2 - t->sines[j]*(x[j] - x[N-j]);
			sum[l] += x[j]*t->cosines[j];
		}
	}
	fftw_execute_dft(t->pair, y, Y);
	for (l = 0; l < 2; l++) {
		line[l][0] = Y[0][l];
		line[l][1] = sum[l];
	}
	for (k = 1; 2*k <= N; k++) {
		Both c = both(Y, N, k);

		for (l = 0; l < 2; l++) {
			line[l][2*k] = c.R[l];
			sum[l] += c.I[l];
			if (2*k < N)
				line[l][2*k+1] = sum[l];
		}
	}
}
