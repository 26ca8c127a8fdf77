/* flat.c - mends flat faces: short edges are collapsed, long ones are flipped.  In one round no two
 * changes touch the same vertex; rounds go on until no flat face can be mended any more. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../mesh/fail.h"
#include "area.h"
#include "flat.h"
#include "join.h"

/* The data of a round. */
typedef struct Round {
	Sheet *s;
	int   *first, *corner;          /* the corners at each vertex */
	int   *to;                      /* [nv] the vertex that replaces each */
	unsigned char *locked, *keep, *boundary;        /* of vertices, of faces, of vertices */
	int   *stamp, count;            /* marks of vertices */
} Round;

/* Sets *shortest and *longest to sides of face f.  Returns 0 if f is not flat (flat.h); 1 if it is, and
 * its shortest edge over its longest is at most FLAT_SHAPE; otherwise 2. */
static int
flatness(const Sheet *s, int f, int *shortest, int *longest)
{
	double length[3];
	int k, lo = 0, hi = 0;

	for (k = 0; k < 3; k++) {
		length[k] = sheet_length(s, 3*f + k);
		if (length[k] < length[lo])
			lo = k;
		if (length[k] > length[hi])
			hi = k;
	}
	*shortest = 3*f + lo;
	*longest = 3*f + hi;
	if (2*sheet_area(s, f) > FLAT_SHAPE*length[hi]*length[hi])
		return 0;
	return length[lo] <= FLAT_SHAPE*length[hi] ? 1 : 2;
}

int
flat_count(const Sheet *s)
{
	int f, n = 0, lo, hi;

	for (f = 0; f < s->nf; f++)
		n += flatness(s, f, &lo, &hi) != 0;
	return n;
}

/* Whether v or a vertex of one of its faces is locked; locks them all if lock is not 0. */
static int
locked(Round *r, int v, int lock)
{
	int i, k, any = r->locked[v];

	for (i = r->first[v]; i < r->first[v+1]; i++)
		for (k = 0; k < 3; k++) {
			unsigned char *l = &r->locked[r->s->tri[r->corner[i] - r->corner[i]%3 + k]];

			any |= *l;
			*l |= (unsigned char)lock;
		}
	return any;
}

/* The number of vertices, other than a and b, that share a face with a and a face with b. */
static int
common(Round *r, int a, int b)
{
	const int before = ++r->count, after = ++r->count;
	int i, k, n = 0, *v;

	for (i = r->first[a]; i < r->first[a+1]; i++)
		for (k = 0; k < 3; k++)
			r->stamp[r->s->tri[r->corner[i] - r->corner[i]%3 + k]] = before;
	for (i = r->first[b]; i < r->first[b+1]; i++)
		for (k = 0; k < 3; k++) {
			v = &r->stamp[r->s->tri[r->corner[i] - r->corner[i]%3 + k]];
			n += *v == before;
			*v = after;
		}
	return n - 2;                   /* a and b themselves */
}

static int
neighbours(Round *r, int a, int b)
{
	int i, k;

	for (i = r->first[a]; i < r->first[a+1]; i++)
		for (k = 0; k < 3; k++)
			if (r->s->tri[r->corner[i] - r->corner[i]%3 + k] == b)
				return 1;
	return 0;
}

/* Merges the ends of a side if the result is still a manifold surface, and counts it.  Returns whether it
 * does. */
static int
collapse(Round *r, int side, Flattened *sum)
{
	const int t = r->s->twin[side];
	int a = r->s->tri[side], b = sheet_to(r->s, side), c;

	if (locked(r, a, 0) || locked(r, b, 0))
		return 0;
	if (common(r, a, b) != 1 + (t >= 0) || (t >= 0 && r->boundary[a] && r->boundary[b]))
		return 0;
	if (r->boundary[a] != r->boundary[b] ? r->boundary[b] : b < a)
		c = a, a = b, b = c;
	r->to[b] = a;
	if (sum->edge[0] < 0 && r->s->source[a] >= 0 && r->s->source[b] >= 0)
		sum->edge[0] = r->s->source[a], sum->edge[1] = r->s->source[b];
	sum->collapsed++;
	r->keep[side/3] = 0;
	if (t >= 0)
		r->keep[t/3] = 0;
	locked(r, a, 1);
	locked(r, b, 1);
	return 1;
}

/* Replaces the edge of a side by the other diagonal of its two faces. */
static int
flip(Round *r, int side)
{
	Sheet *s = r->s;
	const int t = s->twin[side], a = s->tri[side], b = sheet_to(s, side);
	const int p = s->tri[sheet_prev(side)], q = s->tri[sheet_prev(t)];
	int *f = s->tri + 3*(size_t)(side/3), *g = s->tri + 3*(size_t)(t/3);

	if (locked(r, a, 0) || locked(r, b, 0) || r->locked[p] || r->locked[q] || p == q || neighbours(r, p, q))
		return 0;
	locked(r, a, 1);
	locked(r, b, 1);
	f[0] = p, f[1] = a, f[2] = q;
	g[0] = q, g[1] = b, g[2] = p;
	s->filled[side/3] = s->filled[t/3];
	return 1;
}

/* Drops the face of a boundary side. */
static int
drop(Round *r, int side)
{
	if (locked(r, r->s->tri[side], 0) || locked(r, sheet_to(r->s, side), 0))
		return 0;
	r->keep[side/3] = 0;
	locked(r, r->s->tri[side], 1);
	locked(r, sheet_to(r->s, side), 1);
	return 1;
}

/* Finds the changes of one round.  Returns their number. */
static int
mend_some(Round *r, Flattened *sum)
{
	int f, lo, hi, kind, done, all = 0;

	sum->left = 0, sum->at = -1;
	for (f = 0; f < r->s->nf; f++) {
		if (!r->keep[f] || (kind = flatness(r->s, f, &lo, &hi)) == 0)
			continue;
		if (kind == 1)
			done = collapse(r, lo, sum);
		else if (r->s->twin[hi] < 0)
			sum->dropped += done = drop(r, hi);
		else
			sum->flipped += done = flip(r, hi);
		if (!done && sum->left++ == 0)
			sum->at = r->s->tri[3*(size_t)f];
		all += done;
	}
	return all;
}

static int
begin(Round *r, Sheet *s)
{
	int i, e;

	r->s = s;
	if ((e = sheet_corners(s->tri, 3*s->nf, s->nv, &r->first, &r->corner, s->err)) != 0)
		return e;
	r->to = mesh_alloc(s->err, (size_t)s->nv, sizeof *r->to);
	r->stamp = mesh_alloc(s->err, (size_t)s->nv, sizeof *r->stamp);
	r->locked = mesh_alloc(s->err, (size_t)s->nv, 1);
	r->boundary = mesh_alloc(s->err, (size_t)s->nv, 1);
	r->keep = mesh_alloc(s->err, (size_t)s->nf, 1);
	if (!r->to || !r->stamp || !r->locked || !r->boundary || !r->keep)
		return MESH_ENOMEM;
	for (i = 0; i < s->nv; i++)
		r->to[i] = i;
	memset(r->stamp, 0, (size_t)s->nv*sizeof *r->stamp);
	memset(r->locked, 0, (size_t)s->nv);
	memset(r->boundary, 0, (size_t)s->nv);
	memset(r->keep, 1, (size_t)s->nf);
	for (i = 0; i < 3*s->nf; i++)
		if (s->twin[i] < 0)
			r->boundary[s->tri[i]] = r->boundary[sheet_to(s, i)] = 1;
	return 0;
}

static void
end(Round *r)
{
	free(r->first);
	free(r->corner);
	free(r->to);
	free(r->stamp);
	free(r->locked);
	free(r->boundary);
	free(r->keep);
}

/* Makes the changes of a round, and finds the neighbours again. */
static int
apply(Round *r)
{
	Sheet *s = r->s;
	int i, e, many, at[2], merged, split;

	for (i = 0; i < 3*s->nf; i++)
		s->tri[i] = r->to[s->tri[i]];
	free(s->twin);
	s->twin = NULL;
	if ((e = sheet_keep(s, r->keep)) != 0 || (e = sheet_join(s, &many, at, NULL)) != 0)
		return e;
	return sheet_part(s, NULL, &merged, &split);
}

int
flat_mend(Sheet *s, Flattened *sum)
{
	int done = 1, e = 0;

	*sum = (Flattened){ .edge = { -1, -1 }, .at = -1 };
	if (flat_count(s) == 0)
		return 0;
	while (!e && done) {
		Round r = { 0 };

		if ((e = begin(&r, s)) == 0 && (done = mend_some(&r, sum)) > 0)
			e = apply(&r);
		end(&r);
	}
	return e;
}
