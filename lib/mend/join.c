/* join.c - the twins of a sheet, also where more than two faces meet at an edge. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/vec3.h"
#include "../mesh/fail.h"
#include "area.h"
#include "join.h"

/* A side, in the list of its lower vertex; hi is the other one. */
typedef struct Side {
	int hi, side;
} Side;

static int
by_edge(const void *a, const void *b)
{
	const Side *x = a, *y = b;

	if (x->hi != y->hi)
		return x->hi < y->hi ? -1 : 1;
	return x->side < y->side ? -1 : x->side > y->side;
}

static int
low(const Sheet *s, int side)
{
	return s->tri[side] < sheet_to(s, side) ? s->tri[side] : sheet_to(s, side);
}

/* Sorts the sides by their lower vertex, then by the other; first is [nv+2]. */
static void
sort_sides(const Sheet *s, int *first, Side *side)
{
	int i, v;

	memset(first, 0, ((size_t)s->nv + 2)*sizeof *first);
	for (i = 0; i < 3*s->nf; i++)
		first[low(s, i) + 2]++;
	for (v = 2; v < s->nv + 2; v++)
		first[v] += first[v-1];
	for (i = 0; i < 3*s->nf; i++) {
		v = low(s, i);
		side[first[v+1]++] = (Side){ s->tri[i] + sheet_to(s, i) - v, i };
	}
	for (v = 0; v < s->nv; v++)
		qsort(side + first[v], (size_t)(first[v+1] - first[v]), sizeof *side, by_edge);
}

/* The number of sides on the edge of side[i], which is the first of them. */
static int
on_edge(const Side *side, int i, int end)
{
	int k = i + 1;

	while (k < end && side[k].hi == side[i].hi)
		k++;
	return k - i;
}

static void
pair(Sheet *s, int a, int b)
{
	s->twin[a] = b;
	s->twin[b] = a;
}

/* Pairs the sides of each edge of two faces.  Returns the number of edges of more than two faces. */
static int
pair_simple(Sheet *s, const int *first, const Side *side, int at[2])
{
	int v, i, n, many = 0;

	memset(s->twin, -1, 3*(size_t)s->nf*sizeof *s->twin);
	for (v = 0; v < s->nv; v++)
		for (i = first[v]; i < first[v+1]; i += n) {
			n = on_edge(side, i, first[v+1]);
			if (n == 2)
				pair(s, side[i].side, side[i+1].side);
			if (n > 2 && many++ == 0)
				at[0] = v, at[1] = side[i].hi;
		}
	return many;
}

/* The area of the part that each face belongs to, where parts are joined by the twins known so
 * far. */
static void
part_areas(const Sheet *s, int *up, double *area)
{
	int f, i;

	for (f = 0; f < s->nf; f++) {
		up[f] = f;
		area[f] = 0;
	}
	for (i = 0; i < 3*s->nf; i++)
		if (s->twin[i] >= 0)
			sheet_unite(up, i/3, s->twin[i]/3);
	for (f = 0; f < s->nf; f++)
		area[sheet_root(up, f)] += sheet_area(s, f);
}

/* Sets d to the direction from the edge of that side into its face, of length 1. */
static void
inward(const Sheet *s, int side, double d[3])
{
	const double *a = sheet_at(s, s->tri[side]), *b = sheet_at(s, sheet_to(s, side));
	double e[3], length;
	int c;

	sub3(b, a, e);
	sub3(sheet_at(s, s->tri[sheet_prev(side)]), a, d);
	for (length = dot3(d, e)/dot3(e, e), c = 0; c < 3; c++)
		d[c] -= length*e[c];
	for (length = norm3(d), c = 0; c < 3; c++)
		d[c] = length > 0 ? d[c]/length : 0;
}

/* How badly the face of side b continues that of side a; less is better.  The cosine of the angle between
 * the two faces, -1 if they lie in one plane; plus 4 if they disagree in orientation. */
static double
bend(const Sheet *s, int a, int b)
{
	double u[3], v[3];

	inward(s, a, u);
	inward(s, b, v);
	return dot3(u, v) + (s->tri[a] == s->tri[b] ? 4 : 0);
}

/* The index of the best of the n sides to pair with side a: of those in the largest part, the one that
 * continues a best.  With a = -1: the first of those in the largest part.  Sides already paired are -1. */
static int
best(const Sheet *s, const int *up, const double *area, const int *side, int n, int a)
{
	int i, found = -1;

	for (i = 0; i < n; i++) {
		double gain;

		if (side[i] < 0 || side[i] == a)
			continue;
		if (found < 0) {
			found = i;
			continue;
		}
		gain = area[up[side[i]/3]] - area[up[side[found]/3]];
		if (gain > 0 || (gain == 0 && a >= 0 && bend(s, a, side[i]) < bend(s, a, side[found])))
			found = i;
	}
	return found;
}

/* Pairs the n sides of one edge, and overwrites `side`.  Marks in flap, unless it is NULL, the faces that
 * are not in the first pair. */
static void
pair_many(Sheet *s, const int *up, const double *area, int *side, int n, unsigned char *flap)
{
	int i, k, left;

	for (left = n; left > 1; left -= 2) {
		i = best(s, up, area, side, n, -1);
		k = best(s, up, area, side, n, side[i]);
		pair(s, side[i], side[k]);
		if (left < n && flap)
			flap[side[i]/3] = flap[side[k]/3] = 1;
		side[i] = side[k] = -1;
	}
	for (i = 0; flap && i < n; i++)
		if (side[i] >= 0)
			flap[side[i]/3] = 1;
}

static int
pair_all_many(Sheet *s, const int *first, const Side *side, unsigned char *flap)
{
	double *area = mesh_alloc(s->err, (size_t)s->nf, sizeof *area);
	int *up = mesh_alloc(s->err, (size_t)s->nf, sizeof *up);
	int *list = mesh_alloc(s->err, 3*(size_t)s->nf, sizeof *list), v, i, k, n, f;
	const int e = area && up && list ? 0 : MESH_ENOMEM;

	if (!e) {
		part_areas(s, up, area);
		for (f = 0; f < s->nf; f++)
			up[f] = sheet_root(up, f);
	}
	for (v = 0; !e && v < s->nv; v++)
		for (i = first[v]; i < first[v+1]; i += n) {
			n = on_edge(side, i, first[v+1]);
			for (k = 0; k < n; k++)
				list[k] = side[i+k].side;
			if (n > 2)
				pair_many(s, up, area, list, n, flap);
		}
	free(area);
	free(up);
	free(list);
	return e;
}

int
sheet_join(Sheet *s, int *many, int at[2], unsigned char *flap)
{
	int *first = mesh_alloc(s->err, (size_t)s->nv + 2, sizeof *first), e = MESH_ENOMEM;
	Side *side = mesh_alloc(s->err, 3*(size_t)s->nf, sizeof *side);

	free(s->twin);
	s->twin = mesh_alloc(s->err, 3*(size_t)s->nf, sizeof *s->twin);
	if (first && side && s->twin) {
		sort_sides(s, first, side);
		*many = pair_simple(s, first, side, at);
		if (flap)
			memset(flap, 0, (size_t)s->nf);
		e = *many ? pair_all_many(s, first, side, flap) : 0;
	}
	free(first);
	free(side);
	return e;
}
