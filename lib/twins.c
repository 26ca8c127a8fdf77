/* twins.c - which side of which face lies along which other: the table of edges. */
#include <stdlib.h>
#include <string.h>

#include "meshpriv.h"
#include "topology.h"

/* A side at the lower of its vertices. */
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

/* Few sides meet at most vertices: insertion is faster there. */
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
		for (j = i; j > 0 && bysides(&x, &s[j-1]) < 0; j--)
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

/* Put the sides into buckets by their lower vertex: bucket v is start[v]..start[v+1]-1. */
static void
buckets(const Topology *t, int *start, Side *s)
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

/* Join the sides of the edges from v upwards. */
static int
pair(Topology *t, int v, Side *s, int n)
{
	int i, k;

	sort(s, (size_t)n);
	for (i = 0; i < n; i = k) {
		for (k = i + 1; k < n && s[k].hi == s[i].hi; k++)
			continue;
		if (k - i > 2)
			return mesh_fail(t->err, MESH_EMANIFOLD, "edge %d-%d belongs to %d faces",
			    topology_name(t, v), topology_name(t, s[i].hi), k - i);
		t->nedge++;
		t->twin[s[i].side] = k - i == 2 ? s[i+1].side : -1;
		if (k - i == 1)
			continue;
		t->twin[s[i+1].side] = s[i].side;
		if (topology_from(t, s[i].side) == topology_from(t, s[i+1].side))
			t->odd = 1;
	}
	return 0;
}

int
topology_twins(Topology *t)
{
	const size_t n = 3 * (size_t)t->nf;
	int *start, v, e = MESH_ENOMEM;
	Side *s;

	t->nedge = 0;
	t->odd = 0;
	t->twin = mesh_alloc(t->err, n, sizeof *t->twin);
	start = mesh_alloc(t->err, (size_t)t->nv + 2, sizeof *start);
	s = mesh_alloc(t->err, n, sizeof *s);
	if (t->twin && start && s) {
		buckets(t, start, s);
		for (e = 0, v = 0; !e && v < t->nv; v++)
			e = pair(t, v, s + start[v], start[v+1] - start[v]);
	}
	free(start);
	free(s);
	if (e) {
		free(t->twin);
		t->twin = NULL;
	}
	return e;
}
