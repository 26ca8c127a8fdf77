/* crossings.c - the lists of crossings under a flip, and their places by unfolding. */
#include <complex.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "crossings.h"

static int
crossings_of(const Intrinsic *t, int h)
{
	return t->crossings[t->edge[h]];
}

/* The mesh edge at crossing p of side h, counted from the start of the side. */
static int
mesh_edge_at(const Intrinsic *t, int h, int p)
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
		n[k] = crossings_of(t, 3*triangle + k);
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

/* A crossing of a side, counted from the start of the side; or at < 0: a corner. */
typedef struct At {
	int side, at;
} At;

/* Where the mesh edge that enters a triangle at crossing p of its side h leaves it.  at = -1: it
 * ends at the opposite corner. */
static At
follow(const Intrinsic *t, int h, int p)
{
	int next = intrinsic_next(h), last = intrinsic_last(h), n = crossings_of(t, h);
	Pieces c = crossings_pieces(t, h/3);

	if (p < c.round[h%3])
		return (At){ last, crossings_of(t, last) - 1 - p };
	if (n - 1 - p < c.round[next%3])
		return (At){ next, n - 1 - p };
	return (At){ last, -1 };
}

/* The same crossing seen from the other triangle. */
static At
across(const Intrinsic *t, At a)
{
	return (At){ t->twin[a.side], crossings_of(t, a.side) - 1 - a.at };
}

/* The list of the new edge while it is made. */
typedef struct List {
	int *edge, n;
} List;

/* Of the triangles of h and its twin g: the mesh edges across side `outer`, next to the start of
 * the new edge, that cross the new edge too.  Those that turn round the start do not. */
static void
add_from_outer_side(const Intrinsic *t, int h, int outer, int turning, List *l)
{
	int p, n = crossings_of(t, outer);

	for (p = 0; p < n; p++) {
		At a = follow(t, outer, p);

		if (a.side == h && a.at >= 0) {
			a = across(t, a);
			a = follow(t, a.side, a.at);
			if (a.side != turning || a.at < 0)
				continue;
		}
		l->edge[l->n++] = mesh_edge_at(t, outer, p);
	}
}

/* The mesh edges that start at the corner opposite to `side`, from the end of that side. */
static void
add_from_corner(const Intrinsic *t, int side, List *l)
{
	int p;

	for (p = crossings_of(t, side) - 1; p >= 0; p--)
		if (follow(t, side, p).at < 0)
			l->edge[l->n++] = mesh_edge_at(t, side, p);
}

/* The mesh edge that runs from the corner opposite to side h to that opposite to its twin, or -1. */
static int
mesh_edge_along(const Intrinsic *t, int h)
{
	int p;

	for (p = 0; p < crossings_of(t, h); p++) {
		At a = across(t, (At){ h, p });

		if (follow(t, h, p).at < 0 && follow(t, a.side, a.at).at < 0)
			return mesh_edge_at(t, h, p);
	}
	return -1;
}

/* With h from i to j, k opposite to it and l opposite to its twin g, the new edge goes from k to l.
 * From k on it crosses the mesh edges that come across ki, then those that start at i, then those
 * across il. */
int
crossings_flip(Intrinsic *t, int h)
{
	int g = t->twin[h], h1 = intrinsic_next(h), h2 = intrinsic_last(h), g1 = intrinsic_next(g), g2 = intrinsic_last(g);
	int e = t->edge[h], along, *list;
	size_t most = (size_t)crossings_of(t, h1) + crossings_of(t, h2) + crossings_of(t, g1) + crossings_of(t, g2) + 1;
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

/* One crossing of a mesh edge, in the plane that its triangles are unfolded into: the side through
 * which it leaves a triangle, and the end and the start of that side. */
typedef struct Step {
	At     at;
	double complex end, start;
} Step;

/* A mesh edge through the triangles that it crosses, from vertex 0 of the plane. */
typedef struct Strand {
	Step          *step;
	int            n, room;
	double complex last;    /* the vertex at which it ends */
} Strand;

static int
add_step(Strand *s, Step step)
{
	if (s->n == s->room) {
		int room = 2*s->room + 64;
		Step *more = realloc(s->step, room*sizeof *more);

		if (!more)
			return INTRINSIC_ENOMEM;
		s->step = more;
		s->room = room;
	}
	s->step[s->n++] = step;
	return 0;
}

/* The corner opposite to a side that runs from p to q; it lies on the left. */
static double complex
opposite_corner(const Intrinsic *t, int side, double complex p, double complex q)
{
	double y, x = intrinsic_foot(t, side, &y);
	double d = cabs(q - p);

	return d > 0 ? p + (q - p)/d*CMPLX(x, y) : p;
}

/* Follows the mesh edge that starts at the corner opposite to side h and crosses it at p. */
static int
unfold(const Intrinsic *t, int h, int p, Strand *s)
{
	double complex corner, start = intrinsic_length(t, intrinsic_last(h));
	double complex end = opposite_corner(t, intrinsic_last(h), 0, start);
	At a = { h, p };

	s->n = 0;
	for (;;) {
		if (add_step(s, (Step){ a, end, start }))
			return INTRINSIC_ENOMEM;
		a = across(t, a);
		corner = opposite_corner(t, a.side, end, start);
		h = a.side;
		a = follow(t, a.side, a.at);
		if (a.at < 0) {
			s->last = corner;
			return 0;
		}
		if (a.side == intrinsic_next(h))
			end = corner;
		else
			start = corner;
	}
}

static double
clamp(double x, double low, double high)
{
	return !(x > low) ? low : x < high ? x : high;
}

/* The places of the crossings of a strand; its mesh edge is the straight line from 0 to s->last. */
static void
place_strand(const Intrinsic *t, const Strand *s, Places *p)
{
	double complex along = conj(s->last)/(cabs(s->last)*cabs(s->last));
	double reached = 0;
	int k;

	for (k = 0; k < s->n; k++) {
		const Step *step = &s->step[k];
		int side = step->at.side, e = t->edge[side], at = step->at.at;
		double a = cimag(along*step->start), b = cimag(along*step->end);
		double x = clamp(a != b ? a/(a - b) : 0.5, 0, 1);

		reached = clamp(creal(along*(step->start + x*(step->end - step->start))), reached, 1);
		if (t->side[e] != side) {
			at = t->crossings[e] - 1 - at;
			x = 1 - x;
		}
		p->on_mesh[p->first[e] + at] = reached;
		p->on_edge[p->first[e] + at] = x;
	}
}

static int
place_all(const Intrinsic *t, Strand *s, Places *p)
{
	int h, at;

	for (h = 0; h < 3*t->nf; h++)
		for (at = 0; at < crossings_of(t, h); at++) {
			int from_start = t->from[intrinsic_last(h)] == t->mesh_from[mesh_edge_at(t, h, at)];

			if (follow(t, h, at).at >= 0 || !from_start)
				continue;
			if (unfold(t, h, at, s))
				return INTRINSIC_ENOMEM;
			place_strand(t, s, p);
		}
	return 0;
}

/* Rounding may exchange crossings that are close to each other: their order is known. */
static void
keep_order(const Intrinsic *t, Places *p)
{
	size_t k;
	int e;

	for (e = 0; e < t->ne; e++)
		for (k = p->first[e] + 1; k < p->first[e+1]; k++)
			p->on_edge[k] = fmax(p->on_edge[k], p->on_edge[k-1]);
}

int
crossings_places(const Intrinsic *t, Places *p)
{
	Strand s = { NULL, 0, 0, 0 };
	size_t all;
	int e, error = INTRINSIC_ENOMEM;

	*p = (Places){ .first = malloc((t->ne + (size_t)1)*sizeof *p->first) };
	if (p->first) {
		for (p->first[0] = 0, e = 0; e < t->ne; e++)
			p->first[e+1] = p->first[e] + t->crossings[e];
		all = p->first[t->ne];
		p->on_mesh = calloc(all + 1, sizeof *p->on_mesh);
		p->on_edge = calloc(all + 1, sizeof *p->on_edge);
		if (p->on_mesh && p->on_edge)
			error = place_all(t, &s, p);
	}
	free(s.step);
	if (error)
		places_free(p);
	else
		keep_order(t, p);
	return error;
}

void
places_free(Places *p)
{
	free(p->first);
	free(p->on_mesh);
	free(p->on_edge);
	*p = (Places){ 0 };
}
