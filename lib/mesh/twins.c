/* twins.c - the twin of each side: the side of the neighbouring face on the same edge. */
#include <stdlib.h>
#include <string.h>

#include "fail.h"
#include "topology.h"

/* A side between two vertices, kept in the list of the one with the lower number; hi is the other. */
typedef struct Side {
	int hi, side;
} Side;

static int
bysides(const void *a, const void *b)
{
	const Side *x = a, *y = b;

	if (x->hi != y->hi)
		return x->hi < y->hi ? -1 : 1;
	return x->side < y->side ? -1 : x->side > y->side;
}

/* Sorts by hi; sides of one edge are in ascending order on entry, and stay so.  Most vertices have
 * few sides, where insertion is faster. */
static void
sort(Side *s, size_t n)
{
	Side x;
	size_t i, j;

	if (n > 32) {
		qsort(s, n, sizeof *s, bysides);
		return;
	}
	for (i = 1; i < n; i++) {
		x = s[i];
		for (j = i; j > 0 && x.hi < s[j-1].hi; j--)
			s[j] = s[j-1];
		s[j] = x;
	}
}

static int
low(const Topology *t, int side)
{
	const int a = topology_from(t, side), b = topology_to(t, side);

	return a < b ? a : b;
}

static int
high(const Topology *t, int side)
{
	return topology_from(t, side) + topology_to(t, side) - low(t, side);
}

/* Sorts the sides by their lower vertex v, into s[start[v]] .. s[start[v+1]-1]. */
static void
sort_by_lower(const Topology *t, int *start, Side *s)
{
	const int n = 3 * t->nf;
	int i, v;

	memset(start, 0, ((size_t)t->nv + 2) * sizeof *start);
	for (i = 0; i < n; i++)
		start[low(t, i) + 2]++;
	for (v = 2; v < t->nv + 2; v++)
		start[v] += start[v-1];
	for (i = 0; i < n; i++) {
		v = low(t, i);
		s[start[v+1]++] = (Side){ high(t, i), i };
	}
}

/* Pairs the n sides that have the same lower vertex.  nedge counts the edges, odd becomes 1 if two
 * twins run in the same direction.  Returns 0.  If an edge belongs to more than two faces, returns
 * their number, with the other end of the edge in *hi. */
static int
pair(const Topology *t, Side *s, int n, int *nedge, int *odd, int *hi)
{
	int i, k;

	sort(s, (size_t)n);
	for (i = 0; i < n; i = k) {
		for (k = i + 1; k < n && s[k].hi == s[i].hi; k++)
			continue;
		*hi = s[i].hi;
		if (k - i > 2)
			return k - i;
		++*nedge;
		t->twin[s[i].side] = k - i == 2 ? s[i+1].side : -1;
		if (k - i == 1)
			continue;
		t->twin[s[i+1].side] = s[i].side;
		if (topology_from(t, s[i].side) == topology_from(t, s[i+1].side))
			*odd = 1;
	}
	return 0;
}

/* The vertex of the face of a side that is not on the side. */
static int
apex(const Topology *t, int side)
{
	return t->tri[topology_next(topology_next(side))];
}

/* Fails with the reason why n faces have the edge from lo to hi: two of them have the same vertices, or
 * not.  The sides of the edge are among those at s, together. */
static int
too_many(const Topology *t, const Side *s, int n, int lo, int hi)
{
	int i, k;

	while (s->hi != hi)
		s++;
	for (i = 0; i < n; i++)
		for (k = 0; k < i; k++)
			if (apex(t, s[i].side) == apex(t, s[k].side))
				return mesh_fail(t->err, MESH_EMANIFOLD, "edge %d-%d belongs to %d faces, two of them on "
				    "vertices %d %d %d: said twice; mesh2disk drops one", topology_name(t, lo),
				    topology_name(t, hi), n, topology_name(t, lo), topology_name(t, hi),
				    topology_name(t, apex(t, s[i].side)));
	return mesh_fail(t->err, MESH_EMANIFOLD, "edge %d-%d belongs to %d faces; mesh2disk parts them",
	    topology_name(t, lo), topology_name(t, hi), n);
}

/* Pairs the sides at all vertices.  Of edges with too many faces, one at the lowest vertex is
 * reported. */
static int
pair_all(Topology *t, const int *start, Side *s)
{
	int nedge = 0, odd = 0, bad = t->nv, v, n, hi;

#pragma omp parallel for schedule(static) private(hi) \
	reduction(+:nedge) reduction(|:odd) reduction(min:bad)
	for (v = 0; v < t->nv; v++)
		if (pair(t, s + start[v], start[v+1] - start[v], &nedge, &odd, &hi) && v < bad)
			bad = v;
	t->nedge = nedge;
	t->odd = odd;
	if (bad == t->nv)
		return 0;
	n = pair(t, s + start[bad], start[bad+1] - start[bad], &nedge, &odd, &hi);
	return too_many(t, s + start[bad], n, bad, hi);
}

int
topology_twins(Topology *t)
{
	const size_t n = 3 * (size_t)t->nf;
	int *start, e = MESH_ENOMEM;
	Side *s;

	t->nedge = 0;
	t->odd = 0;
	t->twin = mesh_alloc(t->err, n, sizeof *t->twin);
	start = mesh_alloc(t->err, (size_t)t->nv + 2, sizeof *start);
	s = mesh_alloc(t->err, n, sizeof *s);
	if (t->twin && start && s) {
		sort_by_lower(t, start, s);
		e = pair_all(t, start, s);
	}
	free(start);
	free(s);
	if (e) {
		free(t->twin);
		t->twin = NULL;
	}
	return e;
}
