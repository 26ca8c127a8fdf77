/* cosine.c - cosine transforms by FFTW's real ones. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cosine.h"

/* y, its transform behind it at a place as aligned as the first. */
static size_t
behind(int n)
{
	return ((size_t)n + 8)/8*8;
}

size_t
cosine_room(const Cosine *c)
{
	return behind(c->n - 1) + 2*((c->n - 1)/2 + 1);
}

void
cosine_free(Cosine *c)
{
	if (c->plan)
		fftw_destroy_plan(c->plan);
	free(c->sines);
	free(c->cosines);
	memset(c, 0, sizeof *c);
}

int
cosine_init(Cosine *c, int n)
{
	int N = n - 1, j;
	double *work;

	*c = (Cosine){ .n = n, .sines = malloc(N*sizeof(double)), .cosines = malloc(N*sizeof(double)) };
	work = fftw_alloc_real(cosine_room(c));
	if (work)
		c->plan = fftw_plan_dft_r2c_1d(N, work, (fftw_complex *)(work + behind(N)), FFTW_ESTIMATE);
	fftw_free(work);
	if (!c->plan || !c->sines || !c->cosines) {
		cosine_free(c);
		return -1;
	}
	for (j = 0; j < N; j++) {
		c->sines[j] = sin(M_PI*j/N);
		c->cosines[j] = cos(M_PI*j/N);
	}
	return 0;
}

/* With y_j = (f_j + f_{N-j})/2 - sin(pi j/N)(f_j - f_{N-j}) and R - iI its transform,
 * F_2k = R_k and F_2k+1 - F_2k-1 = I_k, F_1 summed. */
void
cosine_transform(const Cosine *c, double *f, double *work)
{
	int N = c->n - 1, j, k;
	double *y = work, sum = (f[0] - f[N])/2;
	fftw_complex *Y = (fftw_complex *)(work + behind(N));

	y[0] = (f[0] + f[N])/2;
	for (j = 1; j < N; j++) {
		y[j] = (f[j] + f[N-j])/2 - c->sines[j]*(f[j] - f[N-j]);
		sum += f[j]*c->cosines[j];
	}
	fftw_execute_dft_r2c(c->plan, y, Y);
	f[0] = Y[0][0];
	f[1] = sum;
	for (k = 1; 2*k <= N; k++) {
		f[2*k] = Y[k][0];
		sum -= Y[k][1];
		if (2*k < N)
			f[2*k+1] = sum;
	}
}
