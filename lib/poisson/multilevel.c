/* multilevel.c - one grid of multigrid: its unknowns, its rim, and the next coarser grid. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "multilevel.h"

static const double SQUARE = 1.5;       /* both axes are coarsened up to this ratio of the steps */

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

/* The stored place of the node whose value rim node (i,j) has, i and j counted from the first unknown:
 * at a free side the mirror image of (i,j), at a joined side the node that lies there.  -1 if the field
 * is held at 0 there. */
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

void
multilevel_fill_rim(const Multilevel *l, double *x)
{
	int q;

	for (q = 0; q < l->rims; q++)
		x[l->rim[q]] = l->source[q] < 0 ? 0 : x[l->source[q]];
}
