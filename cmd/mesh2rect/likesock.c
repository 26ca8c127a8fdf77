/* likesock.c - which cone of a sock corresponds to which cone of another. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../lib/base/procrustes.h"
#include "../shared/borderread.h"
#include "../shared/chartof.h"
#include "likesock.h"

static const double CLEAR = 1.25;       /* boundaries at distances within this factor fit equally well */

static void
read_sock(const char *path, CmdInput *in, Lhg *g)
{
	cmd_open(in, path);
	cmd_read_one(in, g);
	if (g->chart != LHG_SOCK)
		die("%s: --like with --chart=sock needs a sock, this is a %s", in->name, lhg_chartname(g->chart));
}

void
likesock_size(const char *path, Chart *g)
{
	CmdInput in;
	Lhg like;

	read_sock(path, &in, &like);
	g->nu = like.nu;
	g->nv = like.nv;
	lhg_free(&like);
}

/* Moves n points to mean 0 and scales them to root mean square 1. */
static void
normalize(int n, double *x)
{
	double mean[3] = { 0, 0, 0 }, sum = 0;
	int i;

	for (i = 0; i < 3*n; i++)
		mean[i%3] += x[i]/n;
	for (i = 0; i < 3*n; i++)
		sum = hypot(sum, x[i] -= mean[i%3]);
	for (i = 0; i < 3*n && sum > 0; i++)
		x[i] *= sqrt(n)/sum;
}

/* The distance of the boundary of the grid, turned by `turn` columns, from the normalized curve a. */
static double
apart(int n, const double *a, const Grid *grid, int turn)
{
	double *x = cmd_alloc(n, 3*sizeof *x), rms = HUGE_VAL;
	Rigid r;
	int k, c;

	for (k = 0; k < n; k++)
		for (c = 0; c < 3; c++)
			x[3*k+c] = grid->phi[c][(size_t)(grid->g.nv - 1)*n + (n - 1 - k + turn)%n];
	normalize(n, x);
	if (procrustes(n, NULL, a, x, &r, &rms))
		rms = HUGE_VAL;
	free(x);
	return rms;
}

static void
turn_rows(Chart g, double *f)
{
	double *row, t;
	int i, j, half = g.nu/2;

	for (j = 0; j < g.nv; j++)
		for (row = f + (size_t)j*g.nu, i = 0; i < half; i++)
			t = row[i], row[i] = row[i+half], row[i+half] = t;
}

static void
turn(Conformal *c, int vertices)
{
	int k, i, cone = c->cone[0];

	turn_rows(c->grid.g, c->grid.x);
	turn_rows(c->grid.g, c->grid.y);
	for (k = 0; k < 3; k++)
		turn_rows(c->grid.g, c->grid.phi[k]);
	for (i = 0; i < vertices; i++)
		c->u[i] = c->u[i] < 0.5 ? c->u[i] + 0.5 : c->u[i] - 0.5;
	c->cone[0] = c->cone[1];
	c->cone[1] = cone;
}

double
likesock_turn(const char *path, int vertices, Conformal *c)
{
	double d[2];
	CmdInput in;
	Border b;
	Lhg g;
	int k;

	read_sock(path, &in, &g);
	border_read(&in, &g, &b);
	normalize(b.n, b.x);
	for (k = 0; k < 2; k++)
		d[k] = apart(b.n, b.x, &c->grid, k*b.n/2);
	detail("%s: boundaries %.3g of their size apart, %.3g with the cones exchanged", in.name, d[0], d[1]);
	if (d[1] < d[0])
		turn(c, vertices);
	if (fmax(d[0], d[1]) <= CLEAR*fmin(d[0], d[1]))
		note("%s: the boundaries fit equally well with the cones exchanged (%.3g and %.3g of their size apart)",
		    in.name, d[0], d[1]);
	border_free(&b);
	lhg_free(&g);
	return fmin(d[0], d[1]);
}
