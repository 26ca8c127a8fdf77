/* transform.c - sine and cosine transforms by FFTW's real Fourier transform. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "transform.h"

/* The index in the workspace where the spectrum begins: after the N input numbers, rounded up for
 * alignment. */
static size_t
spectrum_offset(int N)
{
	return ((size_t)N + 8)/8*8;
}

size_t
transform_room(const Transform *t)
{
	return spectrum_offset(t->N) + 2*(t->N/2 + 1);
}

void
transform_free(Transform *t)
{
	if (t->plan)
		fftw_destroy_plan(t->plan);
	if (t->pair)
		fftw_destroy_plan(t->pair);
	free(t->sines);
	free(t->cosines);
	memset(t, 0, sizeof *t);
}

static int
is_fast(int n)
{
	static const int prime[] = { 2, 3, 5, 7 };
	int k;

	for (k = 0; n > 0 && k < 4; k++)
		while (n%prime[k] == 0)
			n /= prime[k];
	return n == 1 || n == 11 || n == 13;
}

int
transform_fast_size(int n, int step)
{
	int d = 0;

	while (!is_fast(n + d) && !is_fast(n - d))
		d += step;
	return is_fast(n + d) ? n + d : n - d;
}

int
transform_init(Transform *t, int N)
{
	double *work;
	int j;

	*t = (Transform){ .N = N, .sines = malloc(N*sizeof(double)), .cosines = malloc(N*sizeof(double)) };
	work = fftw_alloc_real(transform_room(t));
	if (work)
		t->plan = fftw_plan_dft_r2c_1d(N, work, (fftw_complex *)(work + spectrum_offset(N)), FFTW_ESTIMATE);
	fftw_free(work);
	if (!t->plan || !t->sines || !t->cosines) {
		transform_free(t);
		return TRANSFORM_ENOMEM;
	}
	for (j = 0; j < N; j++) {
		t->sines[j] = sin(M_PI*j/N);
		t->cosines[j] = cos(M_PI*j/N);
	}
	return 0;
}

/* With y_j = sin(pi j/N)(f_j + f_{N-j}) + (f_j - f_{N-j})/2 and R - iI its transform,
 * F_2k = I_k and F_2k+1 - F_2k-1 = R_k, F_1 = R_0/2. */
void
transform_sine(const Transform *t, double *f, double *work)
{
	int N = t->N, j, k;
	double *y = work, sum;
	fftw_complex *Y = (fftw_complex *)(work + spectrum_offset(N));

	y[0] = 0;
	for (j = 1; j < N; j++)
		y[j] = t->sines[j]*(f[j-1] + f[N-j-1]) + (f[j-1] - f[N-j-1])/2;
	fftw_execute_dft_r2c(t->plan, y, Y);
	f[0] = sum = Y[0][0]/2;
	for (k = 1; 2*k < N; k++) {
		f[2*k-1] = -Y[k][1];
		sum += Y[k][0];
		if (2*k < N - 1)
			f[2*k] = sum;
	}
}

/* With y_j = (f_j + f_{N-j})/2 - sin(pi j/N)(f_j - f_{N-j}) and R - iI its transform,
 * F_2k = R_k and F_2k+1 - F_2k-1 = I_k; F_1 is summed directly. */
void
transform_cosine(const Transform *t, double *f, double *work)
{
	int N = t->N, j, k;
	double *y = work, sum = (f[0] - f[N])/2;
	fftw_complex *Y = (fftw_complex *)(work + spectrum_offset(N));

	y[0] = (f[0] + f[N])/2;
	for (j = 1; j < N; j++) {
		y[j] = (f[j] + f[N-j])/2 - t->sines[j]*(f[j] - f[N-j]);
		sum += f[j]*t->cosines[j];
	}
	fftw_execute_dft_r2c(t->plan, y, Y);
	f[0] = Y[0][0];
	f[1] = sum;
	for (k = 1; 2*k <= N; k++) {
		f[2*k] = Y[k][0];
		sum -= Y[k][1];
		if (2*k < N)
			f[2*k+1] = sum;
	}
}
