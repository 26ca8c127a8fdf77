/* chol.c - symbolic factorization: finds the supernodes and their rows. */
#include <stdlib.h>
#include <string.h>

#include "chol.h"
#include "etree.h"
#include "front.h"

enum { FEW = 16 };      /* a node of at most this many columns counts as small */

/* A supernode under construction: its first column, and the numbers of its columns, of rows below
 * them, and of stored zeros. */
typedef struct Node {
	int    first, columns, rows;
	double zeros;
} Node;

/* The node that results if a is merged with its parent b.  The columns of b directly follow those
 * of a. */
static Node
merge(const Node *a, const Node *b)
{
	Node m = { a->first, a->columns + b->columns, b->rows, 0 };

	m.zeros = a->zeros + b->zeros + (double)a->columns*(b->columns + b->rows - a->rows);
	return m;
}

/* Whether the merged node m is better than its two parts.  Merging stores some zeros, but saves the
 * overhead of a node.  So a small fraction of zeros is accepted, and a larger one in small
 * nodes. */
static int
worth_merging(const Node *m)
{
	double all = m->columns*((m->columns + 1)/2.0 + m->rows);

	return m->zeros <= (m->columns <= FEW ? 0.35 : 0.03)*all;
}

/* Finds the nodes, children before parents.  Returns their number. */
static int
find_nodes(const Etree *t, Node *node)
{
	int p, n = 0, last;
	Node m;

	for (p = 0; p < t->n; p++) {
		node[n++] = (Node){ p, 1, t->count[p] - 1, 0 };
		while (n > 1) {
			last = node[n-1].first - 1;
			if (t->parent[last] < 0 || t->parent[last] > p)
				break;
			m = merge(&node[n-2], &node[n-1]);
			if (!worth_merging(&m))
				break;
			node[--n - 1] = m;
		}
	}
	return n;
}

static int
store_nodes(Chol *c, const Node *node, int nodes)
{
	size_t rows = 0, at = 0;
	int s;

	c->nodes = nodes;
	c->first = malloc((nodes + (size_t)1)*sizeof *c->first);
	c->parent = malloc((nodes + (size_t)1)*sizeof *c->parent);
	c->below = malloc((nodes + (size_t)1)*sizeof *c->below);
	c->at = malloc((nodes + (size_t)1)*sizeof *c->at);
	if (!c->first || !c->parent || !c->below || !c->at)
		return CHOL_ENOMEM;
	for (s = 0; s <= nodes; s++) {
		c->below[s] = rows;
		c->at[s] = at;
		c->first[s] = s < nodes ? node[s].first : c->n;
		if (s < nodes) {
			Front f = { .columns = node[s].columns, .rows = node[s].rows + 1 };

			front_size(&f);
			rows += node[s].rows;
			at += front_panel(&f, f.blocks);
		}
	}
	return 0;
}

/* Finds the rows below each node, in ascending order.  An entry of the matrix in row p adds row p
 * to the node of its column and to the ancestors of that node, up to, but not including, that of p.
 * Scratch: mark[s], the last row added to node s; node[p], the node of column p; end[s], where the
 * rows of node s end so far. */
static void
find_rows(Chol *c, const Etree *t, int *mark, int *node, size_t *end)
{
	int p, k, s;

	for (s = 0; s < c->nodes; s++) {
		end[s] = c->below[s];
		mark[s] = -1;
		for (p = c->first[s]; p < c->first[s+1]; p++)
			node[p] = s;
	}
	for (s = 0; s < c->nodes; s++) {
		p = t->parent[c->first[s+1] - 1];
		c->parent[s] = p < 0 ? -1 : node[p];
	}
	for (p = 0; p < t->n; p++)
		for (k = t->first[p]; k < t->first[p+1]; k++)
			for (s = node[t->low[k]]; s != node[p] && mark[s] != p; s = c->parent[s]) {
				mark[s] = p;
				c->row[end[s]++] = p;
			}
}

static int
init_rows(Chol *c, Etree *t)
{
	size_t *end = malloc((c->nodes + (size_t)1)*sizeof *end);

	c->row = malloc((c->below[c->nodes] + 1)*sizeof *c->row);
	c->value = aligned_alloc(64, c->at[c->nodes]*sizeof *c->value + 64);
	if (!end || !c->row || !c->value) {
		free(end);
		return CHOL_ENOMEM;
	}
	find_rows(c, t, t->mark, t->count, end);
	free(end);
	return 0;
}

static int
analyze(Chol *c, Etree *t)
{
	Node *node;
	int e;

	if (!(node = malloc((c->n + (size_t)1)*sizeof *node)))
		return CHOL_ENOMEM;
	e = store_nodes(c, node, find_nodes(t, node));
	free(node);
	return e ? e : init_rows(c, t);
}

int
chol_init(Chol *c, const Graph *g, const int *order)
{
	Etree t;
	int e = CHOL_ENOMEM;

	*c = (Chol){ .g = g, .n = g->n };
	if (etree_init(&t, g, order) == 0)
		e = analyze(c, &t);
	c->order = t.order;
	c->place = t.place;
	t.order = t.place = NULL;
	etree_free(&t);
	return e;
}

void
chol_free(Chol *c)
{
	free(c->order);
	free(c->place);
	free(c->first);
	free(c->parent);
	free(c->below);
	free(c->row);
	free(c->at);
	free(c->value);
	*c = (Chol){ 0 };
}

double
chol_bytes(const Chol *c)
{
	return c->at ? sizeof *c->value*(double)c->at[c->nodes] : 0;
}
