/* order.c - nested dissection of the graph of a surface; split.c chooses the separators.
 *
 * Measured on a torus patch, on two cores that had other work, too.  Each entry has the seconds for
 * the order (this code on two threads) + for the numeric factorization by CHOLMOD, the entries of
 * the factor in millions, and the floating-point operations in 10^9:
 *
 *   vertices   AMD                    METIS (cholmod_metis)   this
 *   20 k       .01 + .04   .6  .06    .11 + .04   .6  .04     .04 + .03   .6  .05
 *   100 k      .06 + .30  4.5 1.0     .67 + .21  3.5  .48     .12 + .17  3.8  .56
 *   1 M        .9 + 6.5    66  45     6.8 + 2.6   46   17     1.4 + 2.8   49   19
 *
 * Below 20 k vertices AMD is faster by hundredths of a second.  METIS
 * calls rand(), whose state belongs to the calling program.
 */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "mindegree.h"
#include "order.h"
#include "split.h"
#include "vertexcut.h"

enum {
	LEAF = 64,              /* a piece of at most LEAF vertices is not split */
	TASK = 4096             /* a piece with more vertices is a task */
};

static int
degree(const Graph *g, int i)
{
	return g->first[i+1] - g->first[i];
}

/* Orders a small piece by minimum degree, with bit sets.  near[i] is the set of the remaining
 * neighbours of i in the piece.  outer[i] estimates the number of its neighbours outside the piece:
 * when a vertex is eliminated, the estimates of its neighbours are raised to at least its own.
 * cost[i] is the number of neighbours of both kinds. */
static void
order_leaf(const Piece *p, const Graph *whole)
{
	uint64_t near[LEAF], others;
	int outer[LEAF], cost[LEAF], i, k, best, n = p->g.n;

	for (i = 0; i < n; i++) {
		outer[i] = degree(whole, p->name[i]) - degree(&p->g, i);
		cost[i] = degree(whole, p->name[i]);
		for (near[i] = 0, k = p->g.first[i]; k < p->g.first[i+1]; k++)
			near[i] |= UINT64_C(1) << p->g.adj[k];
	}
	for (k = 0; k < n; k++) {
		for (best = 0, i = 1; i < n; i++)
			if (cost[i] < cost[best])
				best = i;
		p->order[k] = p->name[best];
		cost[best] = INT32_MAX;
		for (others = near[best]; others; others &= others - 1) {
			i = __builtin_ctzll(others);
			near[i] = (near[i] | near[best]) & ~(UINT64_C(1) << best | UINT64_C(1) << i);
			if (outer[i] < outer[best])
				outer[i] = outer[best];
			cost[i] = __builtin_popcountll(near[i]) + outer[i];
		}
	}
}

/* Makes a piece q of the n vertices on one side of p; number[i] is the number of vertex i in q. */
static int
extract(const Piece *p, const signed char *side, int which, const int *number, int n, Piece *q)
{
	int i, k, m = 0, edges = 0;

	for (i = 0; i < p->g.n; i++)
		if (side[i] == which)
			edges += degree(&p->g, i);
	q->g.n = n;
	q->g.first = malloc((n + 1)*sizeof *q->g.first);
	q->g.adj = malloc(edges*sizeof *q->g.adj + 1);
	q->name = malloc(n*sizeof *q->name + 1);
	q->f = malloc(2*(size_t)n*sizeof *q->f + 1);
	q->again = p->again;
	if (!q->g.first || !q->g.adj || !q->name || !q->f)
		return ORDER_ENOMEM;
	for (edges = 0, i = 0; i < p->g.n; i++)
		if (side[i] == which) {
			q->name[m] = p->name[i];
			q->f[2*m] = p->f[2*i];
			q->f[2*m+1] = p->f[2*i+1];
			q->g.first[m++] = edges;
			for (k = p->g.first[i]; k < p->g.first[i+1]; k++)
				if (side[p->g.adj[k]] == which)
					q->g.adj[edges++] = number[p->g.adj[k]];
		}
	q->g.first[m] = edges;
	return 0;
}

static void
piece_free(Piece *p)
{
	free(p->g.first);
	free(p->g.adj);
	free(p->name);
	free(p->f);
	memset(p, 0, sizeof *p);
}

/* Orders all of p by minimum degree. */
static int
order_whole(const Piece *p)
{
	int i;

	if (mindegree(&p->g, p->order))
		return ORDER_ENOMEM;
	for (i = 0; i < p->g.n; i++)
		p->order[i] = p->name[p->order[i]];
	return 0;
}

/* Makes the halves of p, and puts the separator at the end of the order of p.  count comes from
 * split(); work is scratch, [n]. */
static int
extract_halves(const Piece *p, const signed char *side, const int count[3], int *work, Piece half[2])
{
	int n[3] = { 0, 0, 0 }, i, e;

	for (i = 0; i < p->g.n; i++)
		work[i] = n[(int)side[i]]++;
	for (i = 0; i < p->g.n; i++)
		if (side[i] == CUT_SEPARATOR)
			p->order[count[0] + count[1] + work[i]] = p->name[i];
	half[0].order = p->order;
	half[1].order = p->order + count[0];
	e = extract(p, side, CUT_LEFT, work, count[0], &half[0]);
	return e ? e : extract(p, side, CUT_RIGHT, work, count[1], &half[1]);
}

/* Splits p in two, puts the separator at the end of its order, and frees p.  Without a small
 * separator all of p is ordered, and the halves are empty. */
static int
split_piece(Piece *p, Piece half[2])
{
	int *work = malloc(6*(size_t)p->g.n*sizeof *work), count[3], e = ORDER_ENOMEM;
	signed char *side = malloc(p->g.n);

	memset(half, 0, 2*sizeof *half);
	if (work && side)
		e = split(p, side, count, work) ? extract_halves(p, side, count, work, half) : order_whole(p);
	free(work);
	free(side);
	piece_free(p);
	return e;
}

/* Orders p and frees it. */
static int
dissect_piece(Piece *p, const Graph *whole)
{
	Piece half[2];
	int e, e1 = 0;

	if (p->g.n <= LEAF) {
		order_leaf(p, whole);
		piece_free(p);
		return 0;
	}
	if ((e = split_piece(p, half)) != 0) {
		piece_free(&half[0]);
		piece_free(&half[1]);
		return e;
	}
#pragma omp task shared(e1) if(half[1].g.n > TASK)
	e1 = dissect_piece(&half[1], whole);
	e = dissect_piece(&half[0], whole);
#pragma omp taskwait
	return e ? e : e1;
}

int
order_graph(const Graph *g, int *order)
{
	Piece p = { .order = order, .again = g->n };
	int i, e = ORDER_ENOMEM;

	p.g.n = g->n;
	p.g.first = malloc((g->n + 1)*sizeof *p.g.first);
	p.g.adj = malloc(g->first[g->n]*sizeof *p.g.adj + 1);
	p.name = malloc(g->n*sizeof *p.name + 1);
	p.f = calloc(2*(size_t)g->n + 1, sizeof *p.f);
	if (p.g.first && p.g.adj && p.name && p.f) {
		memcpy(p.g.first, g->first, (g->n + 1)*sizeof *p.g.first);
		memcpy(p.g.adj, g->adj, g->first[g->n]*sizeof *p.g.adj);
		for (i = 0; i < g->n; i++)
			p.name[i] = i;
#pragma omp parallel
#pragma omp single
		e = dissect_piece(&p, g);
	} else
		piece_free(&p);
	return e;
}
