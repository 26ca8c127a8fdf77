/* cholsolve.c - multifrontal factorization, and back substitution.
 *
 * The front of a node is the sum of the matrix entries of its columns and of the updates of its
 * children.  Eliminating its columns leaves an update for its parent.
 *
 * Each subtree with little work is done by one thread.  A node above the subtrees is done by the
 * thread that completes its last child.  Each front adds the updates of its children in a fixed
 * order, so the result depends neither on the threads nor on the choice of subtrees.
 *
 * J. W. H. Liu, The multifrontal method for sparse matrix solution, SIAM Review 34 (1992).
 */
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "cholpriv.h"

enum { SUBTREES = 256 };        /* a subtree has at most 1/SUBTREES of the work */

typedef struct Run {
	const Chol       *c;
	const CholMatrix *a;
	double           *x;            /* [n] by vertex */
	double          **update;       /* [nodes] of each node; NULL when its parent is done */
	int              *child, *sibling;      /* [nodes] first child, next sibling; -1: none */
	int              *pending;      /* [nodes] children not yet done; -1 in a subtree */
	int              *root;         /* [roots] of the subtrees, whose nodes are begin[root] .. root */
	int              *begin;        /* [nodes] the first node of the subtree of each node */
	int               roots, nomemory, bad; /* bad: first column with a bad pivot, or INT_MAX */
} Run;

static int
add_children(Run *r, int s, const Front *f)
{
	int k;

	for (k = r->child[s]; k >= 0; k = r->sibling[k]) {
		if (!r->update[k] || chol_add_child(r->c, k, r->update[k], s, f))
			return CHOL_ENOMEM;
		free(r->update[k]);
		r->update[k] = NULL;
	}
	return 0;
}

/* Computes the columns of the factor that belong to node s, and the update of s. */
static void
eliminate(Run *r, int s)
{
	Front f = chol_front(r->c, s);
	int bad;

	f.update = calloc(front_update(f.blocks - f.pivots), sizeof *f.update);
	chol_fill_panel(r->c, r->a, r->x, s, &f);
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

/* To be called when node s is done.  If s was the last child of its parent, eliminates the parent,
 * and so on up the tree. */
static void
climb(Run *r, int s)
{
	int left;

	while ((s = r->c->parent[s]) >= 0) {
#pragma omp atomic capture seq_cst
		left = --r->pending[s];
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

/* Back substitution: first at the nodes above the subtrees, from the top down, then in the
 * subtrees.  Each thread has its own scratch `sum`. */
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
			if (r->pending[s] >= 0)
				chol_substitute(c, s, z, sum);
#pragma omp for schedule(dynamic, 1)
		for (i = 0; i < r->roots; i++)
			for (s = r->root[i]; s >= r->begin[r->root[i]] && !nomemory; s--)
				chol_substitute(c, s, z, sum);
		free(sum);
	}
	return nomemory ? CHOL_ENOMEM : 0;
}

/* The estimated work in the subtree of each node: w m^2 for a node whose part of the factor is m x w,
 * plus 1000 for each node as overhead.  Entry [nodes] is the total. */
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

/* Sets child, sibling and begin. */
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

/* Chooses the subtrees: the largest ones with at most 1/SUBTREES of the work, and single leaves
 * with more. */
static int
choose_subtrees(Run *r)
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
		r->pending[s] = work[s] > share && r->child[s] >= 0 ? 0 : -1;
		if (r->pending[s] < 0 && (p < 0 || work[p] > share))
			r->root[r->roots++] = s;
	}
	for (s = 0; s < c->nodes; s++)
		if ((p = c->parent[s]) >= 0 && r->pending[p] >= 0)
			r->pending[p]++;
	free(work);
	return 0;
}

static int
run_init(Run *r)
{
	size_t n = r->c->nodes + (size_t)1;
	int *room = malloc(5*n*sizeof *room);

	r->update = calloc(n, sizeof *r->update);
	r->child = room;
	if (!room || !r->update)
		return CHOL_ENOMEM;
	r->sibling = room + n;
	r->pending = room + 2*n;
	r->root = room + 3*n;
	r->begin = room + 4*n;
	return choose_subtrees(r);
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
	int p, e = z ? run_init(&r) : CHOL_ENOMEM;

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

int
chol_again(Chol *c, double *x)
{
	Run r = { .c = c };
	double *z = malloc((c->n + (size_t)1)*sizeof *z);
	int p, s, e = z ? run_init(&r) : CHOL_ENOMEM;

	for (p = 0; !e && p < c->n; p++)
		z[p] = x[c->order[p]];
	for (s = 0; !e && s < c->nodes; s++)
		chol_forward(c, s, z);
	if (!e)
		e = substitute_all(&r, z);
	for (p = 0; !e && p < c->n; p++)
		x[c->order[p]] = z[p];
	run_free(&r);
	free(z);
	return e;
}
