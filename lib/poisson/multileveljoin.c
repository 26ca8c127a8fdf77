/* multileveljoin.c - the interpolation between two grids of multigrid, and its transpose. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/cpu.h"
#include "multilevel.h"

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

/* Row J of the sum of the rows of f with the weights of t.  Taps beyond t->n have weight 0. */
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

/* Sums the rows of f, then the columns, with their weights in the coarse nodes, including the rim.  Then
 * adds each sum in the rim to the node whose value the rim node has. */
void
multilevel_restrict(const Multilevel *l, const Multilevel *c, const double *f, double *to)
{
	size_t row = multilevel_row(c);
	int J, q;

#pragma omp parallel for schedule(static) if(multilevel_many(l))
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

	multilevel_fill_rim(c, c->x);
#pragma omp parallel for schedule(static) private(i) if(multilevel_many(l))
	for (j = 0; j <= c->n[1] + 1; j++) {
		const double *in = c->x + j*multilevel_row(c);
		double *out = l->r + (size_t)j*l->n[0];

		for (i = 0; i < l->n[0]; i++)
			out[i] = in[at[i]] + share[i]*(in[at[i]+1] - in[at[i]]);
	}
#pragma omp parallel for schedule(static) private(i) if(multilevel_many(l))
	for (j = 0; j < l->n[1]; j++) {
		const double *low = l->r + (size_t)l->at[1][j]*l->n[0], *high = low + l->n[0];
		double *x = l->x + multilevel_place(l, 0, j), s = l->share[1][j];

		for (i = 0; i < l->n[0]; i++)
			x[i] += low[i] + s*(high[i] - low[i]);
	}
}
