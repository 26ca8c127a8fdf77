/* embed.c - splits edges until the Delaunay triangulation of a disk can be embedded. */
#include <stdlib.h>
#include <string.h>

#include "../intrinsic/edgepoints.h"
#include "../intrinsic/flips.h"
#include "../intrinsic/mollify.h"
#include "corners.h"
#include "embed.h"
#include "harmonic.h"
#include "vertexkey.h"

enum { ROUNDS = 12, FEET = 4 };         /* rounds of splitting, at most; the first FEET add feet */

/* Whether every map that is linear on edges shrinks inner edge e to a point, because e is a loop, or
 * puts it on a side of the rectangle, because e joins two vertices of that side. */
static int
collapses(const Intrinsic *t, const unsigned char *side, int e)
{
	int end[2];

	intrinsic_ends(t, e, end);
	return t->twin[t->side[e]] >= 0 && (end[0] == end[1] || (side[end[0]] & side[end[1]]));
}

/* Sorts the edges by their lower end: those of vertex i are at[first[i]] .. at[first[i+1]-1].
 * first: [nv+2]. */
static void
sort_by_lower_end(const Intrinsic *t, int *first, int *at)
{
	int e, i, end[2];

	memset(first, 0, (t->nv + (size_t)2)*sizeof *first);
	for (e = 0; e < t->ne; e++) {
		intrinsic_ends(t, e, end);
		first[(end[0] < end[1] ? end[0] : end[1]) + 2]++;
	}
	for (i = 0; i < t->nv; i++)
		first[i+2] += first[i+1];
	for (e = 0; e < t->ne; e++) {
		intrinsic_ends(t, e, end);
		at[first[(end[0] < end[1] ? end[0] : end[1]) + 1]++] = e;
	}
}

/* Marks inner edges that have the same two ends as another edge, because a map that is linear on edges
 * makes the two coincide.  last: workspace, [nv], the last edge to each vertex. */
static void
mark_doubled(const Intrinsic *t, const int *first, const int *at, int *last, unsigned char *marked)
{
	int i, k, end[2];

	memset(last, -1, t->nv*sizeof *last);
	for (i = 0; i < t->nv; i++)
		for (k = first[i]; k < first[i+1]; k++) {
			int e = at[k], j, other;

			intrinsic_ends(t, e, end);
			j = end[0] == i ? end[1] : end[0];
			if (j == i)
				continue;       /* a loop */
			other = last[j];
			last[j] = e;
			if (other < 0)
				continue;
			intrinsic_ends(t, other, end);
			if (end[0] != i && end[1] != i)
				continue;
			marked[e] |= t->twin[t->side[e]] >= 0;
			marked[other] |= t->twin[t->side[other]] >= 0;
		}
}

/* Marks the edges that no map onto the rectangle can keep straight and apart. */
static int
mark_collapsing(const Intrinsic *t, const unsigned char *side, unsigned char *marked)
{
	int *first = malloc((t->nv + (size_t)2)*sizeof *first), *at = malloc(t->ne*sizeof *at);
	int *last = malloc(t->nv*sizeof *last), e, error = EMBED_ENOMEM;

	if (first && at && last) {
		for (e = 0; e < t->ne; e++)
			marked[e] = collapses(t, side, e);
		sort_by_lower_end(t, first, at);
		mark_doubled(t, first, at, last, marked);
		error = 0;
	}
	free(first);
	free(at);
	free(last);
	return error;
}

/* Makes the Delaunay triangulation of s->mesh, and lists the points to be added next. */
static int
triangulate(Embeddable *s, int feet, EdgePoints *points)
{
	unsigned char *side = malloc(s->mesh.d.m.nv), *marked = NULL;
	int e, at;

	intrinsic_free(&s->t);
	e = !side || intrinsic_init_subdivision(&s->t, &s->mesh) ? EMBED_ENOMEM : 0;
	if (!e)
		e = intrinsic_mollify(&s->t) || intrinsic_delaunay(&s->t, s->key) ? EMBED_ENOMEM : 0;
	if (!e)
		marked = malloc(s->t.ne);
	if (!e && !marked)
		e = EMBED_ENOMEM;
	if (!e) {
		corners_given(&s->mesh.d, s->vertex, s->corner, &at);
		harmonic_sides(&s->mesh.d, s->corner, side);
		e = mark_collapsing(&s->t, side, marked);
	}
	points->n = 0;
	if (!e)
		e = edgepoints_middles(&s->t, &s->mesh.d, marked, points) ? EMBED_ENOMEM : 0;
	if (!e && feet)
		e = edgepoints_feet(&s->t, points) ? EMBED_ENOMEM : 0;
	free(side);
	free(marked);
	return e;
}

static int
set_keys(Embeddable *s)
{
	free(s->key);
	s->key = vertex_keys(&s->mesh.d.m, s->vertex);
	return s->key ? 0 : EMBED_ENOMEM;
}

int
embed_init(Embeddable *s, const Disk *d, const int vertex[4])
{
	memset(s, 0, sizeof *s);
	memcpy(s->vertex, vertex, sizeof s->vertex);
	if (subdivision_init(&s->mesh, d))
		return EMBED_ENOMEM;
	if (set_keys(s)) {
		embed_free(s);
		return EMBED_ENOMEM;
	}
	return 0;
}

void
embed_free(Embeddable *s)
{
	subdivision_free(&s->mesh);
	intrinsic_free(&s->t);
	free(s->key);
	s->key = NULL;
}

int
embed_add(Embeddable *s, const EdgePoints *points)
{
	int n = subdivision_add(&s->mesh, points->n, points->point);

	return n < 0 || set_keys(s) || intrinsic_improve(&s->mesh, s->key) ? EMBED_ENOMEM : n;
}

int
embed(Embeddable *s, int most)
{
	EdgePoints points = { NULL, 0, 0 };
	int k, e = 0;

	for (k = 0; !e && k < ROUNDS; k++) {
		e = triangulate(s, k < FEET && s->mesh.d.m.nv < most, &points);
		if (e || points.n == 0 || k + 1 == ROUNDS)
			break;
		e = embed_add(s, &points);
		e = e < 0 ? EMBED_ENOMEM : 0;
	}
	free(points.point);
	return e;
}
