/* bicubic.c - weights of cubic Hermite interpolation, with slopes from five nodes. */
#include <math.h>
#include <stddef.h>

#include "bicubic.h"
#include "stencil.h"

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

/* The first of n nodes that begin at `from`, moved so that none lies beyond an open side. */
static int
within(int from, int n, int nodes, const int joined[2])
{
	if (!joined[1] && from > nodes - n)
		from = nodes - n;
	return !joined[0] && from < 0 ? 0 : from;
}

/* Adds the weights of the slope at node i times `weight` to s->w. */
static void
slope(BicubicSpan *s, int nodes, const int joined[2], int i, double weight)
{
	const int n = nodes < 5 ? nodes : 5;
	int from = within(i - n/2, n, nodes, joined), k;

	for (k = 0; k < n; k++)
		s->w[from - s->first + k] += weight*SLOPE[n][i - from][k];
}

/* Weights of the cubic Hermite interpolation at place x between nodes 0 .. nodes-1. */
static BicubicSpan
hermite_weights(int nodes, const int joined[2], double x)
{
	BicubicSpan s = { 0, nodes < 6 ? nodes : 6, { 0 } };
	int i;
	double t;

	x = joined[0] ? x : fmax(x, 0);
	x = joined[1] ? x : fmin(x, nodes - 1);
	i = joined[1] || x < nodes - 1 ? (int)floor(x) : nodes - 2;
	t = x - i;
	s.first = within(i - 2, s.n, nodes, joined);
	s.w[i - s.first]     += (1 + 2*t)*(1 - t)*(1 - t);
	s.w[i - s.first + 1] += t*t*(3 - 2*t);
	slope(&s, nodes, joined, i, t*(1 - t)*(1 - t));
	slope(&s, nodes, joined, i + 1, -t*t*(1 - t));
	return s;
}

Bicubic
bicubic_at(Chart g, double x, double y)
{
	return (Bicubic){ g, hermite_weights(g.nu, g.kind->joined[0], x),
	    hermite_weights(g.nv, g.kind->joined[1], y) };
}

static int
all_in_grid(const Bicubic *b)
{
	return b->u.first >= 0 && b->u.first + b->u.n <= b->g.nu && b->v.first >= 0 &&
	    b->v.first + b->v.n <= b->g.nv;
}

/* The value where some of the nodes lie beyond joined sides. */
static double
value_beyond(const Bicubic *b, const double *f, int odd)
{
	double sum = 0, row;
	int i, j, sign;
	size_t p;

	for (j = 0; j < b->v.n; j++) {
		for (row = 0, i = 0; i < b->u.n; i++) {
			sign = 1;
			p = stencil_node(b->g, b->u.first + i, b->v.first + j, &sign);
			row += b->u.w[i]*(odd ? sign*f[p] : f[p]);
		}
		sum += b->v.w[j]*row;
	}
	return sum;
}

static double
value_inside(const Bicubic *b, const double *f)
{
	double sum = 0, row;
	int i, j;

	f += (size_t)b->v.first*b->g.nu + b->u.first;
	for (j = 0; j < b->v.n; j++, f += b->g.nu) {
		for (row = 0, i = 0; i < b->u.n; i++)
			row += b->u.w[i]*f[i];
		sum += b->v.w[j]*row;
	}
	return sum;
}

double
bicubic_value(const Bicubic *b, const double *f)
{
	return all_in_grid(b) ? value_inside(b, f) : value_beyond(b, f, 0);
}

double
bicubic_odd(const Bicubic *b, const double *f)
{
	return all_in_grid(b) ? value_inside(b, f) : value_beyond(b, f, 1);
}
