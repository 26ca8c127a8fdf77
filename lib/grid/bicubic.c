/* bicubic.c - weights of cubic Hermite interpolation, with slopes from five nodes. */
#include <math.h>
#include <stddef.h>

#include "bicubic.h"

/* Finite differences for n nodes at distance 1: the slope at node i is sum_j SLOPE[n][i][j] f_j.
 * It is exact for polynomials of degree up to n-1. */
static const double SLOPE[6][5][5] = {
	[2] = { { -1, 1 }, { -1, 1 } },
	[3] = { { -3/2., 2, -1/2. }, { -1/2., 0, 1/2. }, { 1/2., -2, 3/2. } },
	[4] = { { -11/6., 3, -3/2., 1/3. }, { -1/3., -1/2., 1, -1/6. },
	        { 1/6., -1, 1/2., 1/3. }, { -1/3., 3/2., -3, 11/6. } },
	[5] = { { -25/12., 4, -3, 4/3., -1/4. }, { -1/4., -5/6., 3/2., -1/2., 1/12. },
	        { 1/12., -2/3., 0, 2/3., -1/12. }, { -1/12., 1/2., -3/2., 5/6., 1/4. },
	        { 1/4., -4/3., 3, -4, 25/12. } }
};

/* Adds the weights of the slope at node i, 0 <= i < nodes, times `weight` to s->w. */
static void
slope(BicubicSpan *s, int nodes, int i, double weight)
{
	const int n = nodes < 5 ? nodes : 5;
	int from = i - n/2, k;

	from = from < 0 ? 0 : from > nodes - n ? nodes - n : from;
	for (k = 0; k < n; k++)
		s->w[from - s->first + k] += weight*SLOPE[n][i - from][k];
}

/* Weights of the cubic Hermite interpolation at place x between nodes 0 .. nodes-1. */
static BicubicSpan
hermite_weights(int nodes, double x)
{
	BicubicSpan s = { 0, nodes < 6 ? nodes : 6, { 0 } };
	int i;
	double t;

	x = fmin(fmax(x, 0), nodes - 1);
	i = x < nodes - 1 ? (int)x : nodes - 2;
	t = x - i;
	s.first = i - 2 < 0 ? 0 : i - 2 > nodes - s.n ? nodes - s.n : i - 2;
	s.w[i - s.first]     += (1 + 2*t)*(1 - t)*(1 - t);
	s.w[i - s.first + 1] += t*t*(3 - 2*t);
	slope(&s, nodes, i, t*(1 - t)*(1 - t));
	slope(&s, nodes, i + 1, -t*t*(1 - t));
	return s;
}

Bicubic
bicubic_at(int nu, int nv, double x, double y)
{
	return (Bicubic){ nu, hermite_weights(nu, x), hermite_weights(nv, y) };
}

double
bicubic_value(const Bicubic *b, const double *f)
{
	double sum = 0, row;
	int i, j;

	f += (size_t)b->v.first*b->nu + b->u.first;
	for (j = 0; j < b->v.n; j++, f += b->nu) {
		for (row = 0, i = 0; i < b->u.n; i++)
			row += b->u.w[i]*f[i];
		sum += b->v.w[j]*row;
	}
	return sum;
}
