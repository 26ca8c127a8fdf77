/* hole.c - fills holes: those within one edge by splitting it, others by CGAL and fairing. */
#include <stdlib.h>
#include <string.h>

#include "../mesh/fail.h"
#include "area.h"
#include "fair.h"
#include "hole.h"
#include "holefill.h"
#include "join.h"

#define ON_EDGE 1e-6            /* largest distance from the edge, over its length */

static int
longest_side(const Sheet *s, const Loop *l)
{
	int side = l->side, most = side, i;

	for (i = 0; i < l->n; i++, side = loop_next(s, side))
		if (sheet_length(s, side) > sheet_length(s, most))
			most = side;
	return most;
}

/* Whether all vertices of a loop, other than the ends of its longest side, lie on that side, in their
 * order. */
static int
on_edge(const Sheet *s, const Loop *l, int longest)
{
	const double *a = sheet_at(s, s->tri[longest]);
	double e[3], d[3], length2, at, before = 1;
	int i, c, side = loop_next(s, loop_next(s, longest));

	sub3(sheet_at(s, sheet_to(s, longest)), a, e);
	length2 = dot3(e, e);
	for (i = 2; i < l->n; i++, side = loop_next(s, side)) {
		sub3(sheet_at(s, s->tri[side]), a, d);
		at = dot3(d, e)/length2;
		for (c = 0; c < 3; c++)
			d[c] -= at*e[c];
		if (!(at > 0 && at < before && dot3(d, d) <= ON_EDGE*ON_EDGE*length2))
			return 0;
		before = at;
	}
	return l->n > 2;
}

/* Whether a face at the start of a boundary side has vertex v. */
static int
meets(const Sheet *s, int side, int v)
{
	for (; side >= 0; side = s->twin[sheet_prev(side)])
		if (sheet_to(s, side) == v || s->tri[sheet_prev(side)] == v)
			return 1;
	return 0;
}

/* Whether the apex of the longest side has an edge to a vertex that it is to be joined with. */
static int
joined(const Sheet *s, const Loop *l, int longest)
{
	const int apex = s->tri[sheet_prev(longest)];
	int side = loop_next(s, loop_next(s, longest)), i;

	for (i = 2; i < l->n; i++, side = loop_next(s, side))
		if (meets(s, side, apex))
			return 1;
	return 0;
}

/* Replaces the face of the longest side by a fan to the vertices of the loop; tri and filled have room
 * for n - 2 more faces. */
static void
split_face(Sheet *s, const Loop *l, int longest)
{
	const int apex = s->tri[sheet_prev(longest)], face = longest/3;
	int side = loop_next(s, longest), i, *t;

	for (i = 1; i < l->n; i++) {
		const int from = s->tri[side], to = sheet_to(s, side);  /* from b back to a */

		t = s->tri + 3*(size_t)(i == 1 ? face : s->nf);
		side = loop_next(s, side);
		if (i > 1)
			s->filled[s->nf++] = s->filled[face];
		t[0] = to, t[1] = from, t[2] = apex;
	}
}

static int
grow_faces(Sheet *s, size_t n)
{
	int *tri = realloc(s->tri, (n ? n : 1)*3*sizeof *tri);
	unsigned char *filled;

	if (tri)
		s->tri = tri;
	filled = realloc(s->filled, n ? n : 1);
	if (filled)
		s->filled = filled;
	return tri && filled ? 0 : mesh_fail(s->err, MESH_ENOMEM, "no memory for %zu faces", n);
}

/* Whether any face at the loop is locked.  Locks all of them. */
static int
lock_faces(const Sheet *s, const Loop *l, unsigned char *locked)
{
	int side = l->side, i, any = 0;

	for (i = 0; i < l->n; i++, side = loop_next(s, side)) {
		any |= locked[side/3];
		locked[side/3] = 1;
	}
	return any;
}

/* Splits the edges of loops that do not touch each other; returns how many. */
static int
close_some(Sheet *s, const Loop *loop, int n, unsigned char *locked)
{
	int i, longest, room = s->nf, done = 0;

	for (i = 0; i < n; i++)
		room += loop[i].n;
	if (grow_faces(s, (size_t)room))
		return MESH_ENOMEM;
	memset(locked, 0, (size_t)s->nf);
	for (i = 0; i < n; i++) {
		longest = longest_side(s, &loop[i]);
		if (!on_edge(s, &loop[i], longest) || joined(s, &loop[i], longest) || lock_faces(s, &loop[i], locked))
			continue;
		split_face(s, &loop[i], longest);
		done++;
	}
	return done;
}

int
hole_seams(Sheet *s)
{
	int n, done = 1, all = 0, many, at[2], merged, split;
	unsigned char *locked;
	Loop *loop;

	while (done > 0) {
		if ((n = loop_find(s, &loop)) < 0)
			return n;
		locked = mesh_alloc(s->err, (size_t)s->nf, 1);
		done = locked ? close_some(s, loop, n, locked) : MESH_ENOMEM;
		free(loop);
		free(locked);
		if (done > 0 && (sheet_join(s, &many, at, NULL) || sheet_part(s, NULL, &merged, &split)))
			done = MESH_ENOMEM;
		all += done;
	}
	return done < 0 ? done : all;
}

/* Appends the vertices and faces of the patches. */
static int
append(Sheet *s, const HolePatch *p)
{
	const size_t nv = (size_t)s->nv + (size_t)p->m.nv, nf = (size_t)s->nf + (size_t)p->m.nf;
	double *xyz;
	int *source, v;

	if (grow_faces(s, nf))
		return MESH_ENOMEM;
	if ((xyz = realloc(s->xyz, nv*3*sizeof *xyz)) != NULL)
		s->xyz = xyz;
	if ((source = realloc(s->source, nv*sizeof *source)) != NULL)
		s->source = source;
	if (!xyz || !source)
		return mesh_fail(s->err, MESH_ENOMEM, "no memory for %zu vertices", nv);
	memcpy(xyz + 3*(size_t)s->nv, p->m.xyz, 3*(size_t)p->m.nv*sizeof *xyz);
	memcpy(s->tri + 3*(size_t)s->nf, p->m.tri, 3*(size_t)p->m.nf*sizeof *s->tri);
	memset(s->filled + s->nf, 1, (size_t)p->m.nf);
	for (v = 0; v < p->m.nv; v++)
		source[s->nv + v] = -1;
	s->nv = (int)nv;
	s->nf = (int)nf;
	return 0;
}

static void
count(const Sheet *s, const Loop *loop, int n, const HolePatch *p, Filled *r)
{
	int i;

	r->faces += p->m.nf;
	r->vertices += p->m.nv;
	for (i = 0; i < n; i++)
		if (p->done[i]) {
			r->holes++;
			r->longest = larger(r->longest, loop[i].length);
		} else if (r->left++ == 0) {
			r->left_at = s->tri[loop[i].side];
		}
}

/* Appends the patches that CGAL made, fairs them, and finds the neighbours again. */
static int
use_patches(Sheet *s, const HolePatch *p, int order, Filled *r)
{
	const int from = s->nv;
	int e, many, at[2];

	if ((e = append(s, p)) != 0 || (e = sheet_join(s, &many, at, NULL)) != 0)
		return e;
	if (many)
		return mesh_fail(s->err, MESH_EDISK, "a hole at vertex %d was filled across itself", s->source[at[0]]);
	if ((e = fair(s, from, order)) < 0)
		return e;
	r->order = e;
	return 0;
}

int
hole_fill(Sheet *s, const Loop *loop, int n, int order, Filled *r)
{
	const Mesh m = { s->nv, s->nf, s->xyz, s->tri };
	int (*at)[2], i, e;
	HolePatch p;

	if (n == 0)
		return 0;
	if (!(at = mesh_alloc(s->err, (size_t)n, sizeof *at)))
		return MESH_ENOMEM;
	for (i = 0; i < n; i++) {
		at[i][0] = s->tri[loop[i].side];
		at[i][1] = sheet_to(s, loop[i].side);
	}
	e = holefill(&m, n, (const int (*)[2])at, &p);
	free(at);
	if (e)
		return e == HOLEFILL_ENOMEM ? mesh_fail(s->err, MESH_ENOMEM, "no memory to fill %d holes", n) :
		    mesh_fail(s->err, MESH_EDISK, "CGAL cannot fill the holes");
	count(s, loop, n, &p, r);
	e = use_patches(s, &p, order, r);
	holefill_free(&p);
	return e;
}
