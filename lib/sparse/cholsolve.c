/* cholsolve.c - the factor and the solution, front by front.
 *
 * Multifrontal: the front of a node adds up the entries of its columns and the updates of
 * its children, eliminates its columns and leaves an update to its parent.
 *
 * Subtrees of little work are one thread's each, the rest of the tree is climbed by whoever
 * completes the last child of a node.  Each front adds its children in their order, so that
 * neither threads nor the cut can be seen in the result.
 *
 * J. W. H. Liu, The multifrontal method for sparse matrix solution, SIAM Review 34 (1992).
 */
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "cholpriv.h"

enum { SUBTREES = 256 };        /* about so many, of equal work */

typedef struct Run {
	const Chol       *c;
	const CholMatrix *a;
	double           *x;            /* [n] by vertex */
	double          **update;       /* [nodes] of those that wait for their parent */
	int              *child, *sibling;      /* [nodes] the first and the next, rising; -1 */
	int              *waits;        /* [nodes] children that are not done; -1 in a subtree */
	int              *root;         /* [nodes] the subtrees: first[root] .. root */
	int              *begin;        /* [nodes] the first node of each of them */
	int               roots, nomemory, bad;
} Run;

static int
add_children(Run *r, int s, const Front *f)
{
	int k;

	for (k = r->child[s]; k >= 0; k = r->sibling[k]) {
		if (!r->update[k] || chol_add(r->c, k, r->update[k], s, f))
			return CHOL_ENOMEM;
		free(r->update[k]);
		r->update[k] = NULL;
	}
	return 0;
}

/* The part of node s in the factor. */
static void
eliminate(Run *r, int s)
{
	Front f = chol_front(r->c, s);
	int bad;

	f.update = calloc(front_update(f.blocks - f.pivots), sizeof *f.update);
	chol_enter(r->c, r->a, r->x, s, &f);
	if (!f.update || add_children(r, s, &f)) {
		free(f.update);
#pragma omp atomic write
		r->nomemory = 1;
		return;
	}
	bad = front_factor(&f);
	if (bad >= 0) {
#pragma omp critical(cholsolve_bad)
		if (r->c->first[s] + bad < r->bad)
			r->bad = r->c->first[s] + bad;
	}
	r->update[s] = f.update;
}

/* Node s is done; go on with its parent if it is the last child. */
static void
climb(Run *r, int s)
{
	int left;

	while ((s = r->c->parent[s]) >= 0) {
#pragma omp atomic capture seq_cst
		left = --r->waits[s];
		if (left > 0)
			return;
		eliminate(r, s);
	}
}

static void
factor(Run *r)
{
	int i, s;

#pragma omp parallel for schedule(dynamic, 1) private(s)
	for (i = 0; i < r->roots; i++) {
		for (s = r->begin[r->root[i]]; s <= r->root[i]; s++)
			eliminate(r, s);
		climb(r, r->root[i]);
	}
}

/* From the top of the tree, then all its subtrees.  sum is room for each thread. */
static int
substitute_all(const Run *r, double *z)
{
	const Chol *c = r->c;
	int s, i, most = 0, nomemory = 0;

	for (s = 0; s < c->nodes; s++)
		most = c->first[s+1] - c->first[s] > most ? c->first[s+1] - c->first[s] : most;
#pragma omp parallel private(s)
	{
		double *sum = malloc(PRODUCT_ROWS*(size_t)most*sizeof *sum + 1);

		if (!sum) {
#pragma omp atomic write
			nomemory = 1;
		}
#pragma omp barrier
#pragma omp single
		for (s = c->nodes - 1; s >= 0 && !nomemory; s--)
			if (r->waits[s] >= 0)
				chol_substitute(c, s, z, sum);
#pragma omp for schedule(dynamic, 1)
		for (i = 0; i < r->roots; i++)
			for (s = r->root[i]; s >= r->begin[r->root[i]] && !nomemory; s--)
				chol_substitute(c, s, z, sum);
		free(sum);
	}
	return nomemory ? CHOL_ENOMEM : 0;
}

/* Multiplications of each subtree, and for each node that is looked at. */
static double *
count_work(const Chol *c)
{
	double *work = calloc(c->nodes + (size_t)1, sizeof *work), w, m;
	int s;

	for (s = 0; work && s < c->nodes; s++) {
		w = c->first[s+1] - c->first[s];
		m = w + chol_rows(c, s);
		work[s] += 1000 + w*m*m;
		work[c->parent[s] < 0 ? c->nodes : c->parent[s]] += work[s];
	}
	return work;
}

/* Children of each node, and where its subtree begins. */
static void
link_children(Run *r)
{
	const Chol *c = r->c;
	int s, p;

	for (s = 0; s < c->nodes; s++) {
		r->child[s] = -1;
		r->begin[s] = s;
	}
	for (s = 0; s < c->nodes; s++)
		if ((p = c->parent[s]) >= 0 && r->begin[s] < r->begin[p])
			r->begin[p] = r->begin[s];
	for (s = c->nodes - 1; s >= 0; s--)
		if ((p = c->parent[s]) >= 0) {
			r->sibling[s] = r->child[p];
			r->child[p] = s;
		}
}

/* The subtrees: the largest that take no more than their share of the work, and leaves
 * that do. */
static int
cut(Run *r)
{
	const Chol *c = r->c;
	double *work = count_work(c), share;
	int s, p;

	if (!work)
		return CHOL_ENOMEM;
	link_children(r);
	share = work[c->nodes]/SUBTREES;
	for (s = 0; s < c->nodes; s++) {
		p = c->parent[s];
		r->waits[s] = work[s] > share && r->child[s] >= 0 ? 0 : -1;
		if (r->waits[s] < 0 && (p < 0 || work[p] > share))
			r->root[r->roots++] = s;
	}
	for (s = 0; s < c->nodes; s++)
		if ((p = c->parent[s]) >= 0 && r->waits[p] >= 0)
			r->waits[p]++;
	free(work);
	return 0;
}

static int
run_alloc(Run *r)
{
	size_t n = r->c->nodes + (size_t)1;
	int *room = malloc(5*n*sizeof *room);

	r->update = calloc(n, sizeof *r->update);
	r->child = room;
	if (!room || !r->update)
		return CHOL_ENOMEM;
	r->sibling = room + n;
	r->waits = room + 2*n;
	r->root = room + 3*n;
	r->begin = room + 4*n;
	return cut(r);
}

static void
run_free(Run *r)
{
	int s;

	for (s = 0; r->update && s < r->c->nodes; s++)
		free(r->update[s]);
	free(r->update);
	free(r->child);
}

int
chol_solve(Chol *c, const CholMatrix *a, double *x, int *at)
{
	Run r = { .c = c, .a = a, .x = x, .bad = INT_MAX };
	double *z = malloc((c->n + (size_t)1)*sizeof *z);
	int p, e = z ? run_alloc(&r) : CHOL_ENOMEM;

	if (!e) {
		factor(&r);
		e = r.nomemory ? CHOL_ENOMEM : r.bad < INT_MAX ? CHOL_EINDEFINITE : substitute_all(&r, z);
	}
	for (p = 0; !e && p < c->n; p++)
		x[c->order[p]] = z[p];
	if (e == CHOL_EINDEFINITE)
		*at = c->order[r.bad];
	run_free(&r);
	free(z);
	return e;
}
