/* sine.c - sine transforms by FFTW's real ones. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "sine.h"

/* y, its transform behind it at a place as aligned as the first. */
static size_t
behind(int n)
{
	return ((size_t)n + 8)/8*8;
}

size_t
sine_room(const Sine *s)
{
	return behind(s->n + 1) + 2*((s->n + 1)/2 + 1);
}

void
sine_free(Sine *s)
{
	if (s->plan)
		fftw_destroy_plan(s->plan);
	free(s->sines);
	memset(s, 0, sizeof *s);
}

int
sine_init(Sine *s, int n)
{
	double *work;
	int j;

	*s = (Sine){ .n = n, .sines = malloc((n + 1)*sizeof(double)) };
	work = fftw_alloc_real(sine_room(s));
	if (work)
		s->plan = fftw_plan_dft_r2c_1d(n + 1, work, (fftw_complex *)(work + behind(n + 1)),
		    FFTW_ESTIMATE);
	fftw_free(work);
	for (j = 0; s->sines && j <= n; j++)
		s->sines[j] = sin(M_PI*j/(n + 1));
	if (s->plan && s->sines)
		return 0;
	sine_free(s);
	return -1;
}

/* With y_j = sin(pi j/N)(f_j + f_{N-j}) + (f_j - f_{N-j})/2 and R - iI its transform,
 * F_2k = I_k and F_2k+1 - F_2k-1 = R_k, F_1 = R_0/2. */
void
sine_transform(const Sine *s, double *f, double *work)
{
	int N = s->n + 1, j, k;
	double *y = work, sum;
	fftw_complex *Y = (fftw_complex *)(work + behind(N));

	y[0] = 0;
	for (j = 1; j < N; j++)
		y[j] = s->sines[j]*(f[j-1] + f[N-j-1]) + (f[j-1] - f[N-j-1])/2;
	fftw_execute_dft_r2c(s->plan, y, Y);
	f[0] = sum = Y[0][0]/2;
	for (k = 1; 2*k < N; k++) {
		f[2*k-1] = -Y[k][1];
		sum += Y[k][0];
		if (2*k < N - 1)
			f[2*k] = sum;
	}
}
