/* refine.c - longest-edge bisection with closure. */
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "refine.h"
#include "topology.h"
#include "vec3.h"

/* A split in the making.  Side 3f+k of face f goes from its corner k to corner k+1. */
typedef struct Split {
	const Disk *d;
	Topology    t;
	int        *mid;        /* [3*nf] new vertex on each side; -1: not cut, CUT: to be numbered */
	int        *stack, depth;       /* faces whose longest side may have to be cut */
} Split;

enum { CUT = INT_MAX };

static double
length2(const Split *s, int side)
{
	double e[3];

	sub3(&s->d->m.xyz[3*topology_to(&s->t, side)], &s->d->m.xyz[3*topology_from(&s->t, side)], e);
	return dot3(e, e);
}

/* The longest side of face f; of equal ones that of the lowest edge, so that neighbours
 * agree. */
static int
longest(const Split *s, int f)
{
	int k, best = 3*f, side, edge, best_edge;
	double max = -1, l;

	for (k = 0; k < 3; k++) {
		side = 3*f + k;
		l = length2(s, side);
		edge = s->t.twin[side] >= 0 && s->t.twin[side] < side ? s->t.twin[side] : side;
		best_edge = s->t.twin[best] >= 0 && s->t.twin[best] < best ? s->t.twin[best] : best;
		if (l > max || (l == max && edge < best_edge)) {
			max = l;
			best = side;
		}
	}
	return best;
}

/* Cut a side for both its faces; the neighbour has to be looked at again. */
static void
cut(Split *s, int side)
{
	int twin = s->t.twin[side];

	if (s->mid[side] == CUT)
		return;
	s->mid[side] = CUT;
	if (twin >= 0) {
		s->mid[twin] = CUT;
		s->stack[s->depth++] = twin/3;
	}
}

/* Every face with a cut side has its longest side cut.  Each side is cut once, so the
 * stack holds at most one entry a side and one a face. */
static void
close_up(Split *s, const unsigned char *marked)
{
	int f, k;

	for (f = 0; f < s->t.nf; f++)
		for (k = 0; k < 3 && marked[f]; k++)
			cut(s, 3*f + k);
	while (s->depth > 0) {
		f = s->stack[--s->depth];
		cut(s, longest(s, f));
	}
}

/* Number the new vertices; returns how many there are, *faces the faces to come. */
static int
number_cuts(Split *s, int *faces)
{
	int side, twin, n = s->d->m.nv;

	*faces = s->t.nf;
	for (side = 0; side < 3*s->t.nf; side++) {
		if (s->mid[side] < 0)
			continue;
		++*faces;
		twin = s->t.twin[side];
		s->mid[side] = twin >= 0 && twin < side ? s->mid[twin] : n++;
	}
	return n - s->d->m.nv;
}

static void
place(const Split *s, double *xyz)
{
	const double *a, *b;
	int side, c;

	for (side = 0; side < 3*s->t.nf; side++) {
		if (s->mid[side] < 0)
			continue;
		a = &s->d->m.xyz[3*topology_from(&s->t, side)];
		b = &s->d->m.xyz[3*topology_to(&s->t, side)];
		for (c = 0; c < 3; c++)
			xyz[3*(size_t)s->mid[side] + c] = (a[c] + b[c])/2;
	}
}

static int *
emit(int *tri, int a, int b, int c)
{
	tri[0] = a;
	tri[1] = b;
	tri[2] = c;
	return tri + 3;
}

/* The parts of face f: itself, or halves at its longest side AB, each of them halved
 * again where its other old side is cut. */
static int *
emit_face(const Split *s, int f, int *tri)
{
	const int *mid = &s->mid[3*f];
	int side, next, last, A, B, C, m, bc, ca;

	if (mid[0] < 0 && mid[1] < 0 && mid[2] < 0)
		return emit(tri, s->t.tri[3*f], s->t.tri[3*f+1], s->t.tri[3*f+2]);
	side = longest(s, f), next = topology_next(side), last = topology_next(next);
	A = topology_from(&s->t, side), B = topology_to(&s->t, side), C = topology_to(&s->t, next);
	m = s->mid[side], bc = s->mid[next], ca = s->mid[last];
	tri = ca < 0 ? emit(tri, A, m, C) : emit(emit(tri, A, m, ca), ca, m, C);
	return bc < 0 ? emit(tri, m, B, C) : emit(emit(tri, m, B, bc), m, bc, C);
}

/* The loop with the new boundary vertices in it.  next[v] is the new vertex behind
 * boundary vertex v, or -1. */
static int
emit_loop(const Split *s, Disk *finer)
{
	int *next = malloc(s->d->m.nv*sizeof *next), side, i, v;

	finer->loop = malloc(2*(size_t)s->d->nb*sizeof *finer->loop);
	if (!next || !finer->loop) {
		free(next);
		return MESH_ENOMEM;
	}
	for (side = 0; side < 3*s->t.nf; side++)
		if (s->t.twin[side] < 0)
			next[topology_from(&s->t, side)] = s->mid[side];
	for (i = 0; i < s->d->nb; i++) {
		v = s->d->loop[i];
		finer->loop[finer->nb++] = v;
		if (next[v] >= 0)
			finer->loop[finer->nb++] = next[v];
	}
	free(next);
	return 0;
}

static int
build(Split *s, Disk *finer)
{
	int faces, f, n = number_cuts(s, &faces), *tri;
	Mesh *m = &finer->m;

	m->nv = s->d->m.nv + n;
	m->nf = faces;
	m->xyz = malloc(3*(size_t)m->nv*sizeof *m->xyz);
	m->tri = tri = malloc(3*(size_t)m->nf*sizeof *m->tri);
	if (!m->xyz || !m->tri)
		return MESH_ENOMEM;
	memcpy(m->xyz, s->d->m.xyz, 3*(size_t)s->d->m.nv*sizeof *m->xyz);
	place(s, m->xyz);
	for (f = 0; f < s->t.nf; f++)
		tri = emit_face(s, f, tri);
	return emit_loop(s, finer);
}

int
refine_split(const Disk *d, const unsigned char *marked, Disk *finer)
{
	Split s = { .d = d };
	size_t sides = 3*(size_t)d->m.nf;
	int e;

	memset(finer, 0, sizeof *finer);
	s.t = (Topology){ .nv = d->m.nv, .nf = d->m.nf, .tri = d->m.tri, .err = finer->err };
	e = topology_twins(&s.t);
	s.mid = malloc(sides*sizeof *s.mid);
	s.stack = malloc(sides*sizeof *s.stack);
	if (!e && !(s.mid && s.stack))
		e = MESH_ENOMEM;
	if (!e) {
		memset(s.mid, -1, sides*sizeof *s.mid);
		close_up(&s, marked);
		e = build(&s, finer);
	}
	if (e)
		disk_free(finer);
	free(s.t.twin);
	free(s.mid);
	free(s.stack);
	return e;
}
