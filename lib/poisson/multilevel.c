/* multilevel.c - the operator, the smoothing and the interpolation of one grid of multigrid. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/cpu.h"
#include "multilevel.h"

static const double SQUARE = 1.5;       /* both axes are coarsened up to this ratio of the steps */
enum { MANY = 100000 };                 /* unknowns from which on the rows are divided among threads */

static int
many(const Multilevel *l)
{
	return l->n[0] > MANY/l->n[1];
}

/* The range of the unknowns along one axis. */
static void
set_range(Multilevel *l, int axis)
{
	const int *joined = l->g.kind->joined[axis], nodes = axis ? l->g.nv : l->g.nu;

	l->from[axis] = l->held && !joined[0];
	l->n[axis] = nodes - l->from[axis] - (l->held && !joined[1]);
}

/* Whether place i, counted from the first unknown, is on a free open side. */
static int
on_free_side(const Multilevel *l, int axis, int i)
{
	const int *joined = l->g.kind->joined[axis];

	return !l->held && ((i == 0 && !joined[0]) || (i == l->n[axis] - 1 && !joined[1]));
}

/* The weights of the nodes along both axes: the width of their cell, in steps. */
static int
set_widths(Multilevel *l)
{
	int a, i;

	for (a = 0; a < 2; a++) {
		l->width[a] = malloc(l->n[a]*sizeof(double));
		if (!l->width[a])
			return MULTILEVEL_ENOMEM;
		for (i = 0; i < l->n[a]; i++)
			l->width[a][i] = on_free_side(l, a, i) ? 0.5 : 1;
	}
	return 0;
}

/* The place of the node that the rim stands for at (i,j), counted from the first unknown: its mirror
 * image at a free side.  -1 if the field is held at 0 there. */
static int
source_of(const Multilevel *l, int i, int j)
{
	int at[2] = { i, j }, a, out = 0;

	for (a = 0; a < 2; a++) {
		const int *joined = l->g.kind->joined[a];
		int low = at[a] < 0 && !joined[0], high = at[a] >= l->n[a] && !joined[1];

		if ((low || high) && l->held)
			return -1;
		at[a] = low ? 1 : high ? l->n[a] - 2 : at[a];
		out |= at[a] < 0 || at[a] >= l->n[a];
	}
	i = at[0] + l->from[0];
	j = at[1] + l->from[1];
	if (out)
		l->g.kind->beyond(l->g, &i, &j);
	return multilevel_place(l, i - l->from[0], j - l->from[1]);
}

static int
set_rim(Multilevel *l)
{
	int i, j;

	l->rim = malloc((2*(size_t)(l->n[0] + l->n[1]) + 4)*sizeof(int));
	l->source = malloc((2*(size_t)(l->n[0] + l->n[1]) + 4)*sizeof(int));
	if (!l->rim || !l->source)
		return MULTILEVEL_ENOMEM;
	for (j = -1; j <= l->n[1]; j++)
		for (i = -1; i <= l->n[0]; i += j < 0 || j == l->n[1] ? 1 : l->n[0] + 1) {
			l->rim[l->rims] = multilevel_place(l, i, j);
			l->source[l->rims++] = source_of(l, i, j);
		}
	return 0;
}

void
multilevel_free(Multilevel *l)
{
	int a;

	free(l->rim);
	free(l->source);
	free(l->mass);
	free(l->inverse);
	free(l->x);
	free(l->b);
	free(l->r);
	for (a = 0; a < 2; a++) {
		free(l->width[a]);
		free(l->at[a]);
		free(l->taps[a]);
		free(l->share[a]);
	}
	memset(l, 0, sizeof *l);
}

int
multilevel_init(Multilevel *l, Chart g, int held)
{
	size_t n;

	*l = (Multilevel){ .g = g, .held = held };
	set_range(l, 0);
	set_range(l, 1);
	n = multilevel_row(l)*(l->n[1] + 2);
	l->mass = calloc(n, sizeof(double));
	l->inverse = calloc(n, sizeof(double));
	l->x = calloc(n, sizeof(double));
	l->b = calloc(n, sizeof(double));
	l->r = calloc(n, sizeof(double));
	if (l->mass && l->inverse && l->x && l->b && l->r && !set_widths(l) && !set_rim(l))
		return 0;
	multilevel_free(l);
	return MULTILEVEL_ENOMEM;
}

int
multilevel_coarser(const Multilevel *l, Chart *g)
{
	double step[2] = { chart_h(l->g), chart_k(l->g) };
	int nodes[2] = { l->g.nu, l->g.nv }, less[2], can[2], a;

	for (a = 0; a < 2; a++) {
		double steps = chart_steps(l->g, a)/2;

		/* the number of nodes with half the steps */
		less[a] = nodes[a] - (int)floor(steps);
		can[a] = less[a] < nodes[a] && less[a] - (nodes[a] - l->n[a]) > 0;
	}
	if (!can[0] && !can[1])
		return 0;
	*g = l->g;
	if (can[0] && !(can[1] && step[0] > SQUARE*step[1]))
		g->nu = less[0];
	if (can[1] && !(can[0] && step[1] > SQUARE*step[0]))
		g->nv = less[1];
	return 1;
}

/* The places of the unknowns of l among the nodes of c along one axis. */
static int
join_axis(Multilevel *l, const Multilevel *c, int a)
{
	double half = l->g.kind->joined[a][0]*0.5, ratio = chart_steps(c->g, a), place;
	int i, k;

	l->at[a] = malloc(l->n[a]*sizeof(int));
	l->share[a] = malloc(l->n[a]*sizeof(double));
	l->taps[a] = calloc(c->n[a] + 2, sizeof *l->taps[a]);
	if (!l->at[a] || !l->share[a] || !l->taps[a])
		return MULTILEVEL_ENOMEM;
	for (i = 0; i < l->n[a]; i++) {
		place = (i + l->from[a] + half)*ratio/chart_steps(l->g, a) - half - c->from[a] + 1;
		l->at[a][i] = place < c->n[a] + 1 ? (int)floor(place) : c->n[a];
		l->share[a][i] = place - l->at[a][i];
		for (k = 0; k < 2; k++) {
			Taps *t = &l->taps[a][l->at[a][i] + k];
			double w = k ? l->share[a][i] : 1 - l->share[a][i];

			if (w > 0 && t->n == 0)
				t->from = i;
			if (w > 0)
				t->w[t->n++] = w;
		}
	}
	return 0;
}

int
multilevel_join(Multilevel *l, const Multilevel *c)
{
	return join_axis(l, c, 0) || join_axis(l, c, 1) ? MULTILEVEL_ENOMEM : 0;
}

static void
set_rim_of(const Multilevel *l, double *x)
{
	int q;

	for (q = 0; q < l->rims; q++)
		x[l->rim[q]] = l->source[q] < 0 ? 0 : x[l->source[q]];
}

/* t k/h and t h/k, for the second differences along u and v. */
typedef struct Edges {
	double u, v;
} Edges;

static Edges
edges(const Multilevel *l, double t)
{
	double ratio = chart_k(l->g)/chart_h(l->g);

	return (Edges){ t*ratio, t/ratio };
}

void
multilevel_diagonal(Multilevel *l, double t)
{
	Edges e = edges(l, t);
	int i, j;

	for (j = 0; j < l->n[1]; j++)
		for (i = 0; i < l->n[0]; i++) {
			size_t p = multilevel_place(l, i, j);

			l->inverse[p] = 1/(2*(e.u + e.v)*l->width[0][i]*l->width[1][j] + l->mass[p]);
		}
}

typedef enum Product { APPLY, RESIDUAL, RELAX } Product;

/* Row j of one of
 *
 *   APPLY     t K x + w M x
 *   RESIDUAL  b - A x
 *   RELAX     x + w D^-1 (b - A x) = (1 - w) x + w D^-1 (b + (D - A) x) */
INLINE void
fill_row(const Multilevel *l, Product what, Edges e, double w, int j, const double *x, double *out)
{
	size_t p = multilevel_place(l, 0, j), row = multilevel_row(l);
	const double *f = x + p, *s = f - row, *n = f + row, *m = l->mass + p, *b = l->b + p, *d = l->inverse + p;
	double u = e.u*l->width[1][j], v = e.v*l->width[1][j], both = 2*(u + v), sum;
	int i;

	out += p;
	for (i = 0; i < l->n[0]; i++) {
		sum = u*(f[i-1] + f[i+1]) + v*(s[i] + n[i]);
		if (what == APPLY)
			out[i] = l->width[0][i]*(both*f[i] - sum) + w*m[i]*f[i];
		else if (what == RESIDUAL)
			out[i] = b[i] - l->width[0][i]*(both*f[i] - sum) - m[i]*f[i];
		else
			out[i] = (1 - w)*f[i] + w*d[i]*(b[i] + l->width[0][i]*sum);
	}
}

TARGET("avx2") static void
fill_row_256(const Multilevel *l, Product what, Edges e, double w, int j, const double *x, double *out)
{
	switch (what) {
	case APPLY:    fill_row(l, APPLY, e, w, j, x, out); break;
	case RESIDUAL: fill_row(l, RESIDUAL, e, w, j, x, out); break;
	case RELAX:    fill_row(l, RELAX, e, w, j, x, out); break;
	}
}

static void
product(const Multilevel *l, Product what, double t, double w, double *x, double *out)
{
	Edges e = edges(l, t);
	int j;

	set_rim_of(l, x);
#pragma omp parallel for schedule(static) if(many(l))
	for (j = 0; j < l->n[1]; j++)
		if (HAS("avx2"))
			fill_row_256(l, what, e, w, j, x, out);
		else
			fill_row(l, what, e, w, j, x, out);
}

void
multilevel_apply(const Multilevel *l, double t, double c, double *x, double *y)
{
	product(l, APPLY, t, c, x, y);
}

void
multilevel_residual(Multilevel *l, double t)
{
	product(l, RESIDUAL, t, 0, l->x, l->r);
}

void
multilevel_relax(Multilevel *l, double t, double w)
{
	double *swap = l->x;

	product(l, RELAX, t, w, l->x, l->r);
	l->x = l->r;
	l->r = swap;
}

void
multilevel_begin(Multilevel *l, double w)
{
	size_t n = multilevel_row(l)*(l->n[1] + 2), p;

	for (p = 0; p < n; p++)
		l->x[p] = w*l->inverse[p]*l->b[p];
}

/* Row J of P' f before the columns are added up: with w = 0 for taps that a node does not have. */
INLINE void
sum_rows(const Multilevel *l, const Taps *t, const double *f, double *sum)
{
	const double *in[TAPS];
	int i, k;

	for (k = 0; k < TAPS; k++)
		in[k] = f + multilevel_place(l, 0, t->from + (k < t->n ? k : 0));
	for (i = 0; i < l->n[0]; i++)
		sum[i] = t->w[0]*in[0][i] + t->w[1]*in[1][i] + t->w[2]*in[2][i] + t->w[3]*in[3][i];
}

/* Adds up the rows of f, then the columns, with their weights in the coarse nodes, rim and all.  The
 * sums in the rim then go to the nodes that the rim stands for. */
void
multilevel_restrict(const Multilevel *l, const Multilevel *c, const double *f, double *to)
{
	size_t row = multilevel_row(c);
	int J, q;

#pragma omp parallel for schedule(static) if(many(l))
	for (J = 0; J <= c->n[1] + 1; J++) {
		double sum[l->n[0] + TAPS], *out = to + J*row;
		int I;

		memset(sum + l->n[0], 0, TAPS*sizeof *sum);
		sum_rows(l, &l->taps[1][J], f, sum);
		for (I = 0; I <= c->n[0] + 1; I++) {
			const Taps *t = &l->taps[0][I];
			const double *in = sum + t->from;

			out[I] = t->w[0]*in[0] + t->w[1]*in[1] + t->w[2]*in[2] + t->w[3]*in[3];
		}
	}
	for (q = 0; q < c->rims; q++) {
		if (c->source[q] >= 0)
			to[c->source[q]] += to[c->rim[q]];
		to[c->rim[q]] = 0;
	}
}

void
multilevel_prolong(Multilevel *l, Multilevel *c)
{
	const double *share = l->share[0];
	const int *at = l->at[0];
	int i, j;

	set_rim_of(c, c->x);
#pragma omp parallel for schedule(static) private(i) if(many(l))
	for (j = 0; j <= c->n[1] + 1; j++) {
		const double *in = c->x + j*multilevel_row(c);
		double *out = l->r + (size_t)j*l->n[0];

		for (i = 0; i < l->n[0]; i++)
			out[i] = in[at[i]] + share[i]*(in[at[i]+1] - in[at[i]]);
	}
#pragma omp parallel for schedule(static) private(i) if(many(l))
	for (j = 0; j < l->n[1]; j++) {
		const double *low = l->r + (size_t)l->at[1][j]*l->n[0], *high = low + l->n[0];
		double *x = l->x + multilevel_place(l, 0, j), s = l->share[1][j];

		for (i = 0; i < l->n[0]; i++)
			x[i] += low[i] + s*(high[i] - low[i]);
	}
}
