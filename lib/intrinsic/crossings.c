/* crossings.c - reads the lists of crossings, and updates them for a flip. */
#include <stdlib.h>
#include <string.h>

#include "crossings.h"

int
crossings_on(const Intrinsic *t, int h)
{
	return t->crossings[t->edge[h]];
}

int
crossings_mesh_edge(const Intrinsic *t, int h, int p)
{
	int e = t->edge[h];

	return t->crossing[e][t->side[e] == h ? p : t->crossings[e] - 1 - p];
}

Pieces
crossings_pieces(const Intrinsic *t, int triangle)
{
	Pieces c = { { 0, 0, 0 }, { 0, 0, 0 } };
	int n[3], k;

	for (k = 0; k < 3; k++)
		n[k] = crossings_on(t, 3*triangle + k);
	for (k = 0; k < 3; k++) {
		int opposite = n[(k+1)%3], out = n[k], in = n[(k+2)%3];

		c.start[k] = opposite > out + in ? opposite - out - in : 0;
	}
	for (k = 0; k < 3; k++) {
		int next = (k + 1)%3, last = (k + 2)%3;

		if (c.start[k])
			c.round[k] = 0;
		else if (c.start[next])
			c.round[k] = n[k];
		else if (c.start[last])
			c.round[k] = n[last];
		else
			c.round[k] = (n[k] + n[last] - n[next])/2;
	}
	return c;
}

Crossing
crossings_follow(const Intrinsic *t, int h, int p)
{
	int next = intrinsic_next(h), last = intrinsic_last(h), n = crossings_on(t, h);
	Pieces c = crossings_pieces(t, h/3);

	if (p < c.round[h%3])
		return (Crossing){ last, crossings_on(t, last) - 1 - p };
	if (n - 1 - p < c.round[next%3])
		return (Crossing){ next, n - 1 - p };
	return (Crossing){ last, -1 };
}

Crossing
crossings_across(const Intrinsic *t, Crossing a)
{
	return (Crossing){ t->twin[a.side], crossings_on(t, a.side) - 1 - a.at };
}

/* The mesh edges found so far that cross the new edge, in order from its start. */
typedef struct List {
	int *edge, n;
} List;

/* Adds the mesh edges that enter the triangle of h by its side `outer` and cross the new edge.  A
 * mesh edge that leaves this triangle by h crosses the new edge only if it leaves the triangle
 * beyond h by side `turning`. */
static void
add_from_outer_side(const Intrinsic *t, int h, int outer, int turning, List *l)
{
	int p, n = crossings_on(t, outer);

	for (p = 0; p < n; p++) {
		Crossing a = crossings_follow(t, outer, p);

		if (a.side == h && a.at >= 0) {
			a = crossings_across(t, a);
			a = crossings_follow(t, a.side, a.at);
			if (a.side != turning || a.at < 0)
				continue;
		}
		l->edge[l->n++] = crossings_mesh_edge(t, outer, p);
	}
}

/* Adds the mesh edges that go from the corner opposite to `side` across `side`, in the order from the
 * end of `side` to its start. */
static void
add_from_corner(const Intrinsic *t, int side, List *l)
{
	int p;

	for (p = crossings_on(t, side) - 1; p >= 0; p--)
		if (crossings_follow(t, side, p).at < 0)
			l->edge[l->n++] = crossings_mesh_edge(t, side, p);
}

/* The mesh edge that runs from the corner opposite to side h to the corner opposite to its twin, or
 * -1 if there is none.  It becomes the new edge. */
static int
mesh_edge_along(const Intrinsic *t, int h)
{
	int p;

	for (p = 0; p < crossings_on(t, h); p++) {
		Crossing a = crossings_across(t, (Crossing){ h, p });

		if (crossings_follow(t, h, p).at < 0 && crossings_follow(t, a.side, a.at).at < 0)
			return crossings_mesh_edge(t, h, p);
	}
	return -1;
}

/* Let side h run from i to j, with k the corner opposite to h and l the corner opposite to its twin
 * g.  The new edge goes from k to l.  It crosses, in this order, mesh edges that come across ki, the
 * mesh edges that start at i (also ij, if that is a mesh edge), and mesh edges that come across il. */
int
crossings_flip(Intrinsic *t, int h)
{
	int g = t->twin[h], h1 = intrinsic_next(h), h2 = intrinsic_last(h);
	int g1 = intrinsic_next(g), g2 = intrinsic_last(g);
	int e = t->edge[h], along, *list;
	size_t most = (size_t)crossings_on(t, h1) + crossings_on(t, h2) + crossings_on(t, g1)
	    + crossings_on(t, g2) + 1;
	List l = { malloc(most*sizeof(int)), 0 };

	if (!l.edge)
		return INTRINSIC_ENOMEM;
	add_from_outer_side(t, h, h2, g2, &l);
	add_from_corner(t, h1, &l);
	if (t->along[e] >= 0)
		l.edge[l.n++] = t->along[e];
	add_from_corner(t, g2, &l);
	add_from_outer_side(t, g, g1, h1, &l);
	along = mesh_edge_along(t, h);
	list = l.n > 0 ? malloc(l.n*sizeof *list) : NULL;
	if (list)
		memcpy(list, l.edge, l.n*sizeof *list);
	free(l.edge);
	if (l.n > 0 && !list)
		return INTRINSIC_ENOMEM;
	free(t->crossing[e]);
	t->crossing[e] = list;
	t->crossings[e] = l.n;
	t->along[e] = along;
	return 0;
}
