/* refine.c - longest-edge bisection with closure. */
#include <stdlib.h>
#include <string.h>

#include "channel.h"
#include "longestside.h"
#include "refine.h"
#include "topology.h"

/* A refinement under construction.  Side 3f+k of face f goes from its corner k to corner k+1. */
typedef struct Split {
	const Disk *d;
	Topology    t;
	int         similar;    /* 1: split all faces, into four similar ones */
	const double *key;      /* refine.h */
	int        *mid;        /* [3*nf] new vertex on each side; -1: none, SIDE_CUT: no number yet */
	int        *part;       /* [3*nf][2] the new side, or both halves, of each old side */
	int        *tri, *twin, nf;     /* the new faces so far */
} Split;

/* Numbers the new vertices and returns their count.  *faces: the count of faces of the refined
 * mesh. */
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

/* Copies f, n numbers at each old vertex, to `to`.  Appends for each new vertex the mean of the two
 * ends of its side. */
static void
midpoints(const Split *s, int n, const double *f, double *to)
{
	const double *a, *b;
	int side, c;

	memcpy(to, f, (size_t)n*(size_t)s->d->m.nv*sizeof *to);
	for (side = 0; side < 3*s->t.nf; side++) {
		if (s->mid[side] < 0)
			continue;
		a = &f[(size_t)n*topology_from(&s->t, side)];
		b = &f[(size_t)n*topology_to(&s->t, side)];
		for (c = 0; c < n; c++)
			to[(size_t)n*s->mid[side] + c] = (a[c] + b[c])/2;
	}
}

static int
midpoints_of_channels(const Split *s, Disk *finer)
{
	const Channels *from = &s->d->channels;
	double *to;
	int k;

	for (k = 0; k < from->n; k++) {
		const Channel *c = &from->channel[k];

		if (!(to = channel_add(&finer->channels, c->name, c->n, (size_t)finer->m.nv)))
			return MESH_ENOMEM;
		midpoints(s, c->n, c->f, to);
	}
	return 0;
}

/* Adds a face; returns its side a b. */
static int
emit(Split *s, int a, int b, int c)
{
	int side = 3*s->nf++;

	s->tri[side] = a;
	s->tri[side+1] = b;
	s->tri[side+2] = c;
	return side;
}

static void
join_sides(Split *s, int side, int twin)
{
	s->twin[side] = twin;
	s->twin[twin] = side;
}

/* Adds the part A m C of a face, as two halves if CA is cut.  Returns its side m C. */
static int
emit_left(Split *s, int A, int m, int C, int side, int last)
{
	int ca = s->mid[last], left = emit(s, A, m, ca < 0 ? C : ca), right;

	s->part[2*side] = left;
	if (ca < 0) {
		s->part[2*last] = left + 2;
		return left + 1;
	}
	right = emit(s, ca, m, C);
	join_sides(s, left + 1, right);
	s->part[2*last] = right + 2;
	s->part[2*last+1] = left + 2;
	return right + 1;
}

/* Adds the part m B C of a face, as two halves if BC is cut.  Returns its side C m. */
static int
emit_right(Split *s, int m, int B, int C, int side, int next)
{
	int bc = s->mid[next], left = emit(s, m, B, bc < 0 ? C : bc), right;

	s->part[2*side+1] = left;
	s->part[2*next] = left + 1;
	if (bc < 0)
		return left + 2;
	right = emit(s, m, bc, C);
	join_sides(s, left + 2, right);
	s->part[2*next+1] = right + 1;
	return right + 2;
}

static void
emit_similar(Split *s, int f)
{
	const int *mid = &s->mid[3*f], *c = &s->t.tri[3*f];
	int inner = emit(s, mid[0], mid[1], mid[2]), k, l, side;

	for (k = 0; k < 3; k++) {
		l = (k + 2)%3;
		side = emit(s, c[k], mid[k], mid[l]);
		s->part[2*(3*f + k)] = side;
		s->part[2*(3*f + l) + 1] = side + 2;
		join_sides(s, side + 1, inner + l);
	}
}

/* Adds the parts of face f: the face itself, or its two halves at the midpoint of its longest side
 * AB.  Each half is halved again if its other old side is cut. */
static void
emit_face(Split *s, int f)
{
	const int *mid = &s->mid[3*f], *c = &s->t.tri[3*f];
	int side, next, last, left, m, C, k;

	if (s->similar) {
		emit_similar(s, f);
		return;
	}
	if (mid[0] < 0 && mid[1] < 0 && mid[2] < 0) {
		side = emit(s, c[0], c[1], c[2]);
		for (k = 0; k < 3; k++)
			s->part[2*(3*f + k)] = side + k;
		return;
	}
	side = longest_side(s->d, s->key, f), next = topology_next(side), last = topology_next(next);
	m = s->mid[side], C = topology_to(&s->t, next);
	left = emit_left(s, topology_from(&s->t, side), m, C, side, last);
	join_sides(s, left, emit_right(s, m, topology_to(&s->t, side), C, side, next));
}

/* Sets the twins of the new sides that lie on old sides.  A side and its old twin run in opposite
 * directions, so the first half of one is the twin of the second half of the other. */
static void
join_across_old_sides(Split *s)
{
	int side, twin, cut;

	for (side = 0; side < 3*s->t.nf; side++) {
		twin = s->t.twin[side];
		cut = s->mid[side] >= 0;
		s->twin[s->part[2*side]] = twin < 0 ? -1 : s->part[2*twin + cut];
		if (cut)
			s->twin[s->part[2*side+1]] = twin < 0 ? -1 : s->part[2*twin];
	}
}

/* Sets the loop of finer, with the new boundary vertices.  next[v] is the new vertex after boundary
 * vertex v, or -1. */
static int
emit_loop(const Split *s, Disk *finer)
{
	int *next = malloc(s->d->m.nv*sizeof *next), side, i, v;

	finer->loop = malloc((2*(size_t)s->d->nb + 1)*sizeof *finer->loop);
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
	int faces, f, n = number_cuts(s, &faces);
	Mesh *m = &finer->m;

	m->nv = s->d->m.nv + n;
	m->nf = faces;
	m->xyz = malloc(3*(size_t)m->nv*sizeof *m->xyz);
	m->tri = s->tri = malloc(3*(size_t)m->nf*sizeof *m->tri);
	finer->twin = s->twin = malloc(3*(size_t)m->nf*sizeof *s->twin);
	s->part = malloc(6*(size_t)s->t.nf*sizeof *s->part);
	if (!m->xyz || !m->tri || !s->twin || !s->part)
		return MESH_ENOMEM;
	midpoints(s, 3, s->d->m.xyz, m->xyz);
	if (midpoints_of_channels(s, finer))
		return MESH_ENOMEM;
	for (f = 0; f < s->t.nf; f++)
		emit_face(s, f);
	join_across_old_sides(s);
	return emit_loop(s, finer);
}

/* The two ends of the side on which each new vertex lies; nv is the number of old and new
 * vertices. */
static int (*
ends_of_cuts(const Split *s, int nv))[2]
{
	int side, (*ends)[2] = malloc((size_t)(nv - s->d->m.nv)*sizeof *ends + 1);

	for (side = 0; ends && side < 3*s->t.nf; side++)
		if (s->mid[side] >= 0) {
			ends[s->mid[side] - s->d->m.nv][0] = topology_from(&s->t, side);
			ends[s->mid[side] - s->d->m.nv][1] = topology_to(&s->t, side);
		}
	return ends;
}

int
refine_split(const Disk *d, const unsigned char *marked, const double *key, Disk *finer, int (**ends)[2])
{
	Split s = { .similar = !marked, .d = d, .key = key,
	    .t = { .nv = d->m.nv, .nf = d->m.nf, .tri = d->m.tri, .twin = d->twin } };
	int e = MESH_ENOMEM;

	memset(finer, 0, sizeof *finer);
	s.mid = malloc(3*(size_t)d->m.nf*sizeof *s.mid);
	if (s.mid && !cut_sides(d, marked, key, s.mid))
		e = build(&s, finer);
	if (!e && ends) {
		*ends = ends_of_cuts(&s, finer->m.nv);
		e = *ends ? 0 : MESH_ENOMEM;
	}
	if (e)
		disk_free(finer);
	free(s.mid);
	free(s.part);
	return e;
}
