/* path.c - shortest paths along edges, with a binary heap of vertices by distance. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../mesh/fail.h"
#include "area.h"
#include "path.h"

typedef struct PathItem {
	double distance;
	int    v;
} PathItem;

void
path_free(PathTree *t)
{
	free(t->first);
	free(t->corner);
	free(t->via);
	free(t->order);
	free(t->distance);
	free(t->heap);
	memset(t, 0, sizeof *t);
}

int
path_init(PathTree *t, const Sheet *s)
{
	memset(t, 0, sizeof *t);
	if (sheet_corners(s->tri, 3*s->nf, s->nv, &t->first, &t->corner, s->err))
		return MESH_ENOMEM;
	t->via = mesh_alloc(s->err, (size_t)s->nv, sizeof *t->via);
	t->order = mesh_alloc(s->err, (size_t)s->nv, sizeof *t->order);
	t->distance = mesh_alloc(s->err, (size_t)s->nv, sizeof *t->distance);
	t->heap = mesh_alloc(s->err, 6*(size_t)s->nf + 1, sizeof *t->heap);    /* a push for each end of a side */
	if (t->via && t->order && t->distance && t->heap)
		return 0;
	path_free(t);
	return MESH_ENOMEM;
}

/* Equal distances are ordered by vertex, so that paths do not depend on the heap. */
static int
before(const PathItem *a, const PathItem *b)
{
	return a->distance != b->distance ? a->distance < b->distance : a->v < b->v;
}

static void
push(PathTree *t, double distance, int v)
{
	const PathItem x = { distance, v };
	int i = t->count++;

	for (; i > 0 && before(&x, &t->heap[(i-1)/2]); i = (i-1)/2)
		t->heap[i] = t->heap[(i-1)/2];
	t->heap[i] = x;
}

static PathItem
pop(PathTree *t)
{
	const PathItem top = t->heap[0], x = t->heap[--t->count];
	int i = 0, k;

	while ((k = 2*i + 1) < t->count) {
		if (k + 1 < t->count && before(&t->heap[k+1], &t->heap[k]))
			k++;
		if (!before(&t->heap[k], &x))
			break;
		t->heap[i] = t->heap[k];
		i = k;
	}
	t->heap[i] = x;
	return top;
}

static void
relax(PathTree *t, const Sheet *s, int v, int w, int side, const unsigned char *barred)
{
	const double d = t->distance[v] + sheet_length(s, side);

	if ((barred && barred[w]) || !(d < t->distance[w]))
		return;
	t->distance[w] = d;
	t->via[w] = side;
	push(t, d, w);
}

void
path_from(PathTree *t, const Sheet *s, int v, const unsigned char *barred)
{
	int i, c;

	for (i = 0; i < s->nv; i++)
		t->via[i] = -1, t->distance[i] = HUGE_VAL;
	t->n = t->count = 0;
	t->distance[v] = 0;
	push(t, 0, v);
	while (t->count > 0) {
		const PathItem x = pop(t);

		if (x.distance > t->distance[x.v])
			continue;
		t->order[t->n++] = x.v;
		for (i = t->first[x.v]; i < t->first[x.v + 1]; i++) {
			c = t->corner[i];
			relax(t, s, x.v, sheet_to(s, c), c, barred);
			relax(t, s, x.v, s->tri[sheet_prev(c)], sheet_prev(c), barred);
		}
	}
}

int
path_before(const PathTree *t, const Sheet *s, int v)
{
	return s->tri[t->via[v]] + sheet_to(s, t->via[v]) - v;
}

void
path_cut(Sheet *s, int side)
{
	if (s->twin[side] >= 0)
		s->twin[s->twin[side]] = -1;
	s->twin[side] = -1;
}
