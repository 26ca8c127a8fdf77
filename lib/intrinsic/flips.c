/* flips.c - flips of an intrinsic triangulation. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "crossings.h"
#include "flips.h"

enum { FLIPS = 20, SOME = 200000 };     /* at most FLIPS*nf + SOME flips */
static const double COCIRCULAR = 1e-8; /* both diagonals count as Delaunay if |cot a + cot b| is at most
                                         * this times 1 + |cot a| + |cot b| */
static const double FLAT = 1e-7;        /* a diagonal is no choice if it makes a triangle with less than this share of
                                         * the quadrilateral: its three corners may lie on a line */
static const double EQUAL = 1e-9;       /* keys that differ by at most this count as equal */

/* The data of a side while it is renumbered. */
typedef struct Moved {
	int twin, edge, leads;  /* leads: 1 if the side gives its edge the direction */
} Moved;

static Moved
take_side(const Intrinsic *t, int h)
{
	return (Moved){ t->twin[h], t->edge[h], t->side[t->edge[h]] == h };
}

static void
put_side(Intrinsic *t, int h, Moved m)
{
	t->twin[h] = m.twin;
	t->edge[h] = m.edge;
	if (m.twin >= 0)
		t->twin[m.twin] = h;
	if (m.leads)
		t->side[m.edge] = h;
}

/* Renumbers the four outer sides of the quadrilateral of an edge: old[i] becomes new[i].  Two of
 * them may be twins of each other. */
static void
turn_outer_sides(Intrinsic *t, const int old[4], const int new[4])
{
	Moved m[4];
	int i, j;

	for (i = 0; i < 4; i++)
		m[i] = take_side(t, old[i]);
	for (i = 0; i < 4; i++)
		for (j = 0; j < 4; j++)
			if (m[i].twin == old[j]) {
				m[i].twin = new[j];
				break;
			}
	for (i = 0; i < 4; i++)
		put_side(t, new[i], m[i]);
}

/* The quadrilateral of the two triangles at an inner edge ij, with the edge as x axis: the foot of
 * corner k lies xk beyond i and jk before j, its height is yk; the other corner, l, lies on the other side. */
typedef struct Quad {
	double length, xk, jk, yk, xl, jl, yl;
} Quad;

static Quad
quad(const Intrinsic *t, int h)
{
	int g = t->twin[h];
	Quad q = { .length = intrinsic_length(t, h) };

	q.xk = intrinsic_foot(t, h, &q.yk);
	q.jk = t->dot[intrinsic_next(h)]/q.length;
	q.jl = intrinsic_foot(t, g, &q.yl);
	q.xl = t->dot[intrinsic_next(g)]/q.length;
	return q;
}

/* Twice the areas of the triangles that the other diagonal, kl, makes with i and with j. */
static double area_i(const Quad *q) { return q->yl*q->xk + q->yk*q->xl; }
static double area_j(const Quad *q) { return q->yl*q->jk + q->yk*q->jl; }

/* Replaces the edge of side h, from i to j, by the other diagonal of its two triangles, from k to
 * l. */
static int
flip(Intrinsic *t, int h)
{
	int g = t->twin[h], h1 = intrinsic_next(h), h2 = intrinsic_last(h);
	int g1 = intrinsic_next(g), g2 = intrinsic_last(g);
	int i = t->from[h], j = t->from[g], k = t->from[h2], l = t->from[g2], e = t->edge[h];
	Quad q = quad(t, h);
	double x = fabs(q.xk) + fabs(q.xl) < fabs(q.jk) + fabs(q.jl) ? q.xk - q.xl : q.jl - q.jk;
	double y = q.yk + q.yl;

	if (t->crossing && crossings_flip(t, h))
		return INTRINSIC_ENOMEM;
	turn_outer_sides(t, (int[]){ h1, h2, g1, g2 }, (int[]){ h2, g1, g2, h1 });
	t->from[h] = k, t->from[h1] = l, t->from[h2] = j;
	t->from[g] = l, t->from[g1] = k, t->from[g2] = i;
	t->side[e] = h;
	t->length[e] = hypot(x, y);
	t->area[h/3] = fmax(area_j(&q), 0)/2;
	t->area[g/3] = fmax(area_i(&q), 0)/2;
	t->dot[h] = y*q.yk - x*q.jk;
	t->dot[h1] = y*q.yl + x*q.jl;
	t->dot[h2] = q.jk*q.jl - q.yk*q.yl;
	t->dot[g] = y*q.yl - x*q.xl;
	t->dot[g1] = y*q.yk + x*q.xk;
	t->dot[g2] = q.xk*q.xl - q.yk*q.yl;
	return 0;
}

/* The diagonals ij and kl of a quadrilateral cross at the fraction x of ij and y of kl.  Returns
 * whether the key, interpolated linearly along each diagonal, is larger there on ij than on kl. */
static int
is_higher(const double *key, int i, int j, double x, int k, int l, double y)
{
	return key && key[i] + x*(key[j] - key[i]) > key[k] + y*(key[l] - key[k]) + EQUAL;
}

/* Whether to flip the edge of side h: if it is not Delaunay, or if both diagonals are Delaunay, neither makes a
 * flat triangle, and the other one has the smaller key where they cross.  The keys act as heights over the plane of
 * cocircular vertices: such flips lead to the lower convex hull of these heights, whatever
 * triangulation they begin with. */
static int
is_to_flip(const Intrinsic *t, const double *key, int h)
{
	int g = t->twin[h];
	double a, A, b, B, sum, size, y;
	Quad q;

	if (g < 0 || h/3 == g/3)
		return 0;
	intrinsic_cotangent_parts(t, h, &a, &A);
	intrinsic_cotangent_parts(t, g, &b, &B);
	sum = a*B + b*A, size = fabs(a*B) + fabs(b*A) + A*B;
	if (sum > COCIRCULAR*size || !(size > 0))
		return 0;
	if (sum < -COCIRCULAR*size)
		return 1;
	q = quad(t, h);
	if (!(fmin(area_i(&q), area_j(&q)) > FLAT*(area_i(&q) + area_j(&q))))
		return 0;
	y = q.yk/(q.yk + q.yl);
	return is_higher(key, t->from[h], t->from[g], (q.xk + y*(q.xl - q.xk))/q.length,
	    t->from[intrinsic_last(h)], t->from[intrinsic_last(g)], y);
}

/* A stack that contains each edge at most once. */
typedef struct Stack {
	int           *edge, n;
	unsigned char *on;
	const unsigned char *fixed;     /* 1: edges that are never pushed; or NULL */
} Stack;

static void
push(Stack *s, int e)
{
	if (s->on[e] || (s->fixed && s->fixed[e]))
		return;
	s->on[e] = 1;
	s->edge[s->n++] = e;
}

static int
flip_all(Intrinsic *t, const double *key, Stack *s)
{
	size_t flips = 0;
	int h, g;

	while (s->n > 0 && flips < FLIPS*(size_t)t->nf + SOME) {
		int e = s->edge[--s->n];

		s->on[e] = 0;
		h = t->side[e], g = t->twin[h];
		if (!is_to_flip(t, key, h))
			continue;
		if (flip(t, h))
			return INTRINSIC_ENOMEM;
		flips++;
		push(s, t->edge[intrinsic_next(h)]);
		push(s, t->edge[intrinsic_last(h)]);
		push(s, t->edge[intrinsic_next(g)]);
		push(s, t->edge[intrinsic_last(g)]);
	}
	return 0;
}

/* Makes t Delaunay by flips of the edges that are not fixed.  fixed: [ne], or NULL if all may be
 * flipped. */
static int
delaunay(Intrinsic *t, const double *key, const unsigned char *fixed)
{
	Stack s = { malloc(t->ne*sizeof *s.edge), 0, calloc(t->ne, 1), fixed };
	int e, error = INTRINSIC_ENOMEM;

	if (s.edge && s.on) {
		for (e = t->ne - 1; e >= 0; e--)
			push(&s, e);
		error = flip_all(t, key, &s);
	}
	free(s.edge);
	free(s.on);
	return error;
}

int
intrinsic_delaunay(Intrinsic *t, const double *key)
{
	return delaunay(t, key, NULL);
}

int
intrinsic_improve(Subdivision *s, const double *key)
{
	Intrinsic t;
	unsigned char *fixed;
	int h, e = intrinsic_init_subdivision(&t, s);

	if (e)
		return e;
	free(t.crossing);
	t.crossing = NULL;
	fixed = malloc(t.ne);
	e = INTRINSIC_ENOMEM;
	if (fixed) {
		for (h = 0; h < 3*t.nf; h++)
			fixed[t.edge[h]] = !s->inner[h];
		e = delaunay(&t, key, fixed);
	}
	for (h = 0; !e && h < 3*t.nf; h++)
		s->inner[h] = !fixed[t.edge[h]];
	if (!e) {
		memcpy(s->d.m.tri, t.from, 3*(size_t)t.nf*sizeof *t.from);
		memcpy(s->d.twin, t.twin, 3*(size_t)t.nf*sizeof *t.twin);
	}
	free(fixed);
	intrinsic_free(&t);
	return e;
}
