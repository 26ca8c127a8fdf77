/* handle.c - cuts handles along short cycles.  Each edge that is neither in a tree of shortest paths nor
 * crossed by a tree of faces closes a cycle with two of these paths; the shortest cycle is used. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../mesh/fail.h"
#include "area.h"
#include "handle.h"
#include "join.h"
#include "path.h"
#include "piece.h"

enum { BASES = 16 };            /* at most so many base vertices for one cycle */

/* An edge outside the tree of paths, by the length of its cycle through the base. */
typedef struct Chord {
	double length;
	int    side;
} Chord;

typedef struct Search {
	PathTree t;
	Chord   *chord;         /* [3*nf] */
	int     *up;            /* [nf] the tree of faces */
	unsigned char *barred;  /* [nv] of the boundary */
} Search;

static int
longest_first(const void *a, const void *b)
{
	const Chord *x = a, *y = b;

	if (x->length != y->length)
		return x->length > y->length ? -1 : 1;
	return x->side < y->side ? -1 : x->side > y->side;
}

/* The edges of the component of the base that the tree of paths leaves out, longest cycle first. */
static int
find_chords(const Search *w, const Sheet *s, const int *piece, int p)
{
	int i, n = 0, a, b;

	for (i = 0; i < 3*s->nf; i++) {
		a = s->tri[i], b = sheet_to(s, i);
		if (piece[i/3] != p || s->twin[i] < i || w->t.via[a] == i || w->t.via[b] == i ||
		    w->t.via[a] == s->twin[i] || w->t.via[b] == s->twin[i])
			continue;
		w->chord[n].side = i;
		w->chord[n++].length = w->t.distance[a] + w->t.distance[b] + sheet_length(s, i);
	}
	qsort(w->chord, (size_t)n, sizeof *w->chord, longest_first);
	return n;
}

/* The length of the cycle of a chord without the path that both of its ends share. */
static double
trimmed(const Search *w, const Sheet *s, int side)
{
	int a = s->tri[side], b = sheet_to(s, side);
	const double ends = w->t.distance[a] + w->t.distance[b];

	while (a != b)
		if (w->t.distance[a] > w->t.distance[b] || (w->t.distance[a] == w->t.distance[b] && w->t.via[a] >= 0))
			a = path_before(&w->t, s, a);
		else
			b = path_before(&w->t, s, b);
	return ends + sheet_length(s, side) - 2*w->t.distance[a];
}

/* The chord of the shortest cycle for this base vertex, or -1.  The tree of faces crosses chords in the
 * order of their cycles, longest first; two chords remain for each handle.  Chords at the boundary,
 * which the paths do not reach, come first, so the faces round each boundary loop act as one face, as if
 * the loop were closed. */
static int
shortest_chord(Search *w, const Sheet *s, const int *piece, int p, double *length)
{
	const int n = find_chords(w, s, piece, p);
	int i, found = -1;

	for (i = 0; i < s->nf; i++)
		w->up[i] = i;
	for (i = 0; i < n; i++) {
		const int side = w->chord[i].side, f = sheet_root(w->up, side/3);
		const int g = sheet_root(w->up, s->twin[side]/3);
		double l;

		if (f != g) {
			sheet_unite(w->up, f, g);
			continue;
		}
		if (!(w->chord[i].length < HUGE_VAL))
			continue;
		l = trimmed(w, s, side);
		if (found < 0 || l < *length)
			found = side, *length = l;
	}
	return found;
}

static void
search_free(Search *w)
{
	path_free(&w->t);
	free(w->chord);
	free(w->up);
	free(w->barred);
}

static int
search_init(Search *w, const Sheet *s)
{
	int i;

	memset(w, 0, sizeof *w);
	w->chord = mesh_alloc(s->err, 3*(size_t)s->nf, sizeof *w->chord);
	w->up = mesh_alloc(s->err, (size_t)s->nf, sizeof *w->up);
	w->barred = mesh_alloc(s->err, (size_t)s->nv, 1);
	if (!w->chord || !w->up || !w->barred || path_init(&w->t, s)) {
		search_free(w);
		return MESH_ENOMEM;
	}
	memset(w->barred, 0, (size_t)s->nv);
	for (i = 0; i < 3*s->nf; i++)
		if (s->twin[i] < 0)
			w->barred[s->tri[i]] = w->barred[sheet_to(s, i)] = 1;
	return 0;
}

/* The first vertex of piece p that is not on the boundary, or -1. */
static int
inner_vertex(const Search *w, const Sheet *s, const int *piece, int p)
{
	int i;

	for (i = 0; i < 3*s->nf; i++)
		if (piece[i/3] == p && !w->barred[s->tri[i]])
			return s->tri[i];
	return -1;
}

/* Moves the base until the cycle gets no shorter, and leaves in w->t the paths from the best base.
 * Returns the chord of the shortest cycle for that base, or -1. */
static int
shortest_cycle(Search *w, const Sheet *s, const int *piece, int p, double *length)
{
	int base = inner_vertex(w, s, piece, p), best = base, k, side, a, b;
	double l = 0;

	for (*length = HUGE_VAL, k = 0; base >= 0 && k < BASES; k++) {
		path_from(&w->t, s, base, w->barred);
		if ((side = shortest_chord(w, s, piece, p, &l)) < 0 || !(l < *length))
			break;
		best = base;
		*length = l;
		a = s->tri[side], b = sheet_to(s, side);
		base = w->t.distance[a] > w->t.distance[b] ? a : b;     /* far from the base on its cycle */
	}
	if (best < 0)
		return -1;
	path_from(&w->t, s, best, w->barred);
	return shortest_chord(w, s, piece, p, length);
}

/* Cuts along the cycle of a chord. */
static void
cut_cycle(const Search *w, Sheet *s, int side)
{
	int a = s->tri[side], b = sheet_to(s, side), *far;

	path_cut(s, side);
	while (a != b) {
		far = w->t.distance[a] > w->t.distance[b] || (w->t.distance[a] == w->t.distance[b] &&
		    w->t.via[a] >= 0) ? &a : &b;
		path_cut(s, w->t.via[*far]);
		*far = path_before(&w->t, s, *far);
	}
}

/* Cuts one handle of piece p and fills both sides. */
static int
cut_one(Sheet *s, const int *piece, int p, int order, double *length, Filled *r)
{
	int side, twin, merged, split, e;
	double l;
	Loop loop[2];
	Search w;

	if ((e = search_init(&w, s)) != 0)
		return e;
	side = shortest_cycle(&w, s, piece, p, &l);
	if (side < 0) {
		search_free(&w);
		return mesh_fail(s->err, MESH_EDISK, "a handle cannot be cut without touching the boundary");
	}
	twin = s->twin[side];
	cut_cycle(&w, s, side);
	search_free(&w);
	if ((e = sheet_part(s, NULL, &merged, &split)) != 0)
		return e;
	*length += l;
	loop[0] = loop_at(s, side);
	loop[1] = loop_at(s, twin);
	if ((e = hole_fill(s, loop, 2, order, r)) == 0 && r->left)
		e = mesh_fail(s->err, MESH_EDISK, "a handle was cut at vertex %d, but cannot be closed there",
		    s->source[s->tri[side]]);
	return e;
}

int
handle_cut(Sheet *s, int order, int *cuts, double *length, Filled *r)
{
	int *piece, n, p, e = 0;
	Piece *list;

	*length = 0;
	for (*cuts = 0; !e; ++*cuts) {
		list = NULL;
		piece = mesh_alloc(s->err, (size_t)s->nf, sizeof *piece);
		n = piece ? piece_find(s, piece, &list) : MESH_ENOMEM;
		for (p = 0; p < n && list[p].genus == 0; p++)
			continue;
		free(list);
		if (n < 0 || p == n) {
			free(piece);
			return n < 0 ? n : 0;
		}
		e = cut_one(s, piece, p, order, length, r);
		free(piece);
	}
	return e;
}
