/* etree.c - builds the elimination tree row by row.  From each entry of a row it goes up the tree
 * to the first column already visited in this row.
 *
 * T. A. Davis, Direct Methods for Sparse Linear Systems (2006), chapter 4.  Every entry of L is
 * visited once.  Visiting the skeleton matrix would be enough, but needs three times as much code;
 * visiting all entries takes only a tenth of the time of the factorization.
 */
#include <stdlib.h>
#include <string.h>

#include "etree.h"

void
etree_free(Etree *t)
{
	free(t->order);
	free(t->place);
	free(t->first);
	free(t->low);
	free(t->parent);
	free(t->count);
	free(t->mark);
}

static int
alloc(Etree *t, const Graph *g)
{
	size_t n = g->n, edges = g->first[g->n]/2;

	*t = (Etree){ .n = g->n };
	t->order = malloc((n + 1)*sizeof *t->order);
	t->place = malloc((n + 1)*sizeof *t->place);
	t->first = malloc((n + 1)*sizeof *t->first);
	t->low = malloc((edges + 1)*sizeof *t->low);
	t->parent = malloc((n + 1)*sizeof *t->parent);
	t->count = malloc((n + 1)*sizeof *t->count);
	t->mark = malloc((n + 1)*sizeof *t->mark);
	return t->order && t->place && t->first && t->low && t->parent && t->count && t->mark
	    ? 0 : ETREE_ENOMEM;
}

static void
find_low(Etree *t, const Graph *g)
{
	int p, k, m = 0;

	for (p = 0; p < t->n; p++) {
		const int *first = &g->first[t->order[p]];

		t->first[p] = m;
		for (k = first[0]; k < first[1]; k++)
			if (t->place[g->adj[k]] < p)
				t->low[m++] = t->place[g->adj[k]];
	}
	t->first[t->n] = m;
}

static void
find_parents(Etree *t)
{
	int p, q, k;

	for (p = 0; p < t->n; p++) {
		t->parent[p] = -1;
		t->count[p] = 1;
		t->mark[p] = p;
		for (k = t->first[p]; k < t->first[p+1]; k++)
			for (q = t->low[k]; t->mark[q] != p; q = t->parent[q]) {
				if (t->parent[q] < 0)
					t->parent[q] = p;
				t->count[q]++;
				t->mark[q] = p;
			}
	}
}

/* Sets to[p] to the place of column p in a postorder in which the child with the longest column
 * comes directly before its parent.  All arrays are [n+1]: column n is added as a common root of all
 * trees.  Scratch: longest[p], the child of p with the longest column; size[p], the number of
 * columns in the subtree of p; end[p], one past the last place left for the other children of p, whose
 * subtrees are placed from the last to the first. */
static void
postorder(const Etree *t, int *to, int *longest, int *size, int *end)
{
	int p, q;

	memset(longest, -1, (t->n + 1)*sizeof *longest);
	for (p = 0; p <= t->n; p++)
		size[p] = 1;
	for (p = 0; p < t->n; p++) {
		q = t->parent[p] < 0 ? t->n : t->parent[p];
		size[q] += size[p];
		if (longest[q] < 0 || t->count[p] >= t->count[longest[q]])
			longest[q] = p;
	}
	to[t->n] = t->n;
	for (p = t->n; p >= 0; p--) {
		if (p < t->n) {
			q = t->parent[p] < 0 ? t->n : t->parent[p];
			to[p] = (longest[q] == p ? to[q] : end[q]) - 1;
			if (longest[q] != p)
				end[q] -= size[p];
		}
		end[p] = longest[p] < 0 ? to[p] : to[p] - size[longest[p]];
	}
}

/* Sets b[to[i]] = a[i], then swaps a and b. */
static void
permute(int n, const int *to, int **a, int **b)
{
	int *swap = *a, i;

	for (i = 0; i < n; i++)
		(*b)[to[i]] = (*a)[i];
	*a = *b;
	*b = swap;
}

/* Renumbers the columns in postorder. */
static int
to_postorder(Etree *t, const Graph *g)
{
	size_t n = t->n;
	int *room = malloc(3*(n + 1)*sizeof *room), *to = malloc((n + 1)*sizeof *to), p;

	if (!room || !to) {
		free(room);
		free(to);
		return ETREE_ENOMEM;
	}
	postorder(t, to, room, room + n + 1, room + 2*(n + 1));
	free(room);
	for (p = 0; p < t->n; p++)
		t->parent[p] = t->parent[p] < 0 ? -1 : to[t->parent[p]];
	permute(t->n, to, &t->parent, &t->mark);
	permute(t->n, to, &t->count, &t->mark);
	permute(t->n, to, &t->order, &t->mark);
	for (p = 0; p < t->n; p++)
		t->place[t->order[p]] = p;
	find_low(t, g);
	free(to);
	return 0;
}

int
etree_init(Etree *t, const Graph *g, const int *order)
{
	int p;

	if (alloc(t, g))
		return ETREE_ENOMEM;
	for (p = 0; p < g->n; p++)
		t->place[t->order[p] = order[p]] = p;
	find_low(t, g);
	find_parents(t);
	return to_postorder(t, g);
}
