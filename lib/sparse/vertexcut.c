/* vertexcut.c - the smallest vertex separator within a band, by augmenting paths.
 *
 * By Menger's theorem its size is the largest number of paths through the band that share no
 * vertex.  Each vertex v is split into nodes in(v) = 2v and out(v) = 2v+1, joined by an edge that
 * one path may use.  Paths are added one by one; a new path may reroute parts of older ones.  All
 * searches of a round share their marks, so that a round visits the band once, and a few rounds
 * find all paths. */
#include "vertexcut.h"

/* In next and prev, NONE: not on a path; END: end of the path.  In parent, NONE: not visited; END:
 * start of a search. */
enum { NONE = -1, END = -2 };

/* During the search, side[v] of a band vertex is BAND plus a flag for each side that it touches. */
enum { BAND = CUT_SEPARATOR, AT_LEFT = 4, AT_RIGHT = 8 };

typedef struct Cut {
	const Graph *g;
	signed char *side;
	int *next, *prev;       /* [n] on the path through the vertex: a vertex, NONE, or END */
	int *edge;              /* [n] the next edge of out(v) to look at */
	int *parent;            /* [2n] of the search */
	int *band, n;           /* the n vertices of the band */
} Cut;

static void
find_band(Cut *c)
{
	int i, k, v;

	for (v = 0; v < c->g->n; v++)
		if (c->side[v] == CUT_SEPARATOR) {
			c->next[v] = c->prev[v] = NONE;
			c->band[c->n++] = v;
		}
	for (i = 0; i < c->n; i++)
		for (v = c->band[i], k = c->g->first[v]; k < c->g->first[v+1]; k++) {
			int side = c->side[c->g->adj[k]];

			if (side < BAND)
				c->side[v] |= side == CUT_LEFT ? AT_LEFT : AT_RIGHT;
		}
}

/* A node not visited yet that can be reached from `node` in one step, or NONE. */
static int
next_node(Cut *c, int node)
{
	int v = node/2, w;

	if (node%2 == 0) {                              /* at in(v) */
		if (c->next[v] == NONE)
			w = node + 1;
		else
			w = c->prev[v] == END ? NONE : 2*c->prev[v] + 1;
		return w >= 0 && c->parent[w] == NONE ? w : NONE;
	}
	while (c->edge[v] < c->g->first[v+1]) {         /* at out(v) */
		w = c->g->adj[c->edge[v]++];
		if (c->side[w] >= BAND && c->parent[2*w] == NONE)
			return 2*w;
	}
	return c->next[v] != NONE && c->parent[node-1] == NONE ? node - 1 : NONE;
}

/* Adds the path that a search found, from its last node back. */
static void
augment(Cut *c, int node)
{
	int from;

	c->next[node/2] = END;
	for (; (from = c->parent[node]) != END; node = from)
		if (node%2 == 0 && from/2 != node/2) {          /* out(v) -> in(w) */
			c->next[from/2] = node/2;
			c->prev[node/2] = from/2;
		} else if (node%2 == 0)                         /* out(v) -> in(v): v leaves its path */
			c->next[node/2] = c->prev[node/2] = NONE;
	c->prev[node/2] = END;
}

/* Depth-first search from in(v).  Returns 1 if it found a path, which is then added. */
static int
search(Cut *c, int v)
{
	int node = 2*v, to;

	if (c->parent[node] != NONE)
		return 0;
	c->parent[node] = END;
	while (node != END) {
		if (node%2 && (c->side[node/2] & AT_RIGHT) && c->next[node/2] != END) {
			augment(c, node);
			return 1;
		}
		to = next_node(c, node);
		if (to == NONE)
			node = c->parent[node];
		else {
			c->parent[to] = node;
			node = to;
		}
	}
	return 0;
}

static int
one_round(Cut *c)
{
	int i, v, found = 0;

	for (i = 0; i < c->n; i++) {
		v = c->band[i];
		c->parent[2*v] = c->parent[2*v+1] = NONE;
		c->edge[v] = c->g->first[v];
	}
	for (i = 0; i < c->n; i++)
		if (c->side[c->band[i]] & AT_LEFT)
			found += search(c, c->band[i]);
	return found;
}

void
vertexcut(const Graph *g, signed char *side, int *work)
{
	Cut c = { g, side, work, work + g->n, work + 2*g->n, work + 3*g->n, work + 5*g->n, 0 };
	int i, v;

	find_band(&c);
	while (one_round(&c))
		;
	for (i = 0; i < c.n; i++) {
		v = c.band[i];
		if (c.parent[2*v+1] != NONE)
			side[v] = CUT_LEFT;
		else if (c.parent[2*v] == NONE)
			side[v] = CUT_RIGHT;
		else
			side[v] = CUT_SEPARATOR;
	}
}
