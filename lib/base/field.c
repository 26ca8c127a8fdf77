/* field.c - sums and updates of long arrays. */
#include "field.h"

/* A sum over n numbers is split into n/BLOCK + 1 blocks, but at most MOST. */
enum { BLOCK = 4096, MOST = 64 };

static double
dot_block(size_t n, const double *a, const double *b)
{
	double sum[4] = { 0, 0, 0, 0 };
	size_t p;

	for (p = 0; p + 4 <= n; p += 4) {
		sum[0] += a[p]*b[p];
		sum[1] += a[p+1]*b[p+1];
		sum[2] += a[p+2]*b[p+2];
		sum[3] += a[p+3]*b[p+3];
	}
	for (; p < n; p++)
		sum[0] += a[p]*b[p];
	return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

double
field_dot(size_t n, const double *a, const double *b)
{
	size_t blocks = n/BLOCK + 1 < MOST ? n/BLOCK + 1 : MOST, k, from, to;
	double part[MOST], sum = 0;

#pragma omp parallel for schedule(static) private(from, to) if(n > 2*BLOCK)
	for (k = 0; k < blocks; k++) {
		from = n*k/blocks;
		to = n*(k + 1)/blocks;
		part[k] = dot_block(to - from, a + from, b + from);
	}
	for (k = 0; k < blocks; k++)
		sum += part[k];
	return sum;
}

void
field_add(size_t n, double a, const double *x, double *y)
{
	size_t p;

#pragma omp parallel for simd schedule(static) if(n > 2*BLOCK)
	for (p = 0; p < n; p++)
		y[p] += a*x[p];
}

void
field_xpay(size_t n, const double *x, double a, double *y)
{
	size_t p;

#pragma omp parallel for simd schedule(static) if(n > 2*BLOCK)
	for (p = 0; p < n; p++)
		y[p] = x[p] + a*y[p];
}

void
field_scale(size_t n, double a, const double *x, double *y)
{
	size_t p;

#pragma omp parallel for simd schedule(static) if(n > 2*BLOCK)
	for (p = 0; p < n; p++)
		y[p] = a*x[p];
}
