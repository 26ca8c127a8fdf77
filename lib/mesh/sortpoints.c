/* sortpoints.c - sorts points of a disk by triangle and by edge. */
#include <stdlib.h>

#include "sortpoints.h"

/* The same point, given on the side that has the lower number of the two sides of its edge. */
static EdgePoint
seen_from_lower(const Disk *d, EdgePoint p)
{
	int twin = d->twin[p.side];

	return twin < 0 || p.side < twin ? p : (EdgePoint){ twin, 1 - p.place };
}

static int
along_edges(const void *a, const void *b)
{
	const EdgePoint *p = a, *q = b;

	if (p->side != q->side)
		return p->side < q->side ? -1 : 1;
	return p->place < q->place ? -1 : p->place > q->place;
}

/* Sorts the points.  Drops those at a vertex, and those less than 1e-9 beyond the one before on the
 * same edge.  Returns how many are left. */
static int
sort_edge_points(const Disk *d, int n, EdgePoint *point)
{
	int i, k = 0;

	for (i = 0; i < n; i++)
		point[i] = seen_from_lower(d, point[i]);
	qsort(point, n, sizeof *point, along_edges);
	for (i = 0; i < n; i++) {
		if (!(point[i].place > 0 && point[i].place < 1))
			continue;
		if (k > 0 && point[k-1].side == point[i].side && point[i].place - point[k-1].place < 1e-9)
			continue;
		point[k++] = point[i];
	}
	return k;
}

static int
by_triangle(const void *a, const void *b)
{
	const SurfacePoint *p = a, *q = b;
	int k;

	if (p->triangle != q->triangle)
		return p->triangle < q->triangle ? -1 : 1;
	for (k = 0; k < 3; k++)
		if (p->w[k] != q->w[k])
			return p->w[k] < q->w[k] ? -1 : 1;
	return 0;
}

int
sort_points(const Disk *d, int n, const SurfacePoint *point, Sorted *s)
{
	int i, k;

	*s = (Sorted){ malloc(n*sizeof *s->within + 1), malloc(n*sizeof *s->on + 1), 0, 0 };
	if (!s->within || !s->on)
		return MESH_ENOMEM;
	for (i = 0; i < n; i++) {
		for (k = 0; k < 3 && point[i].w[(k+2)%3] != 0; k++)
			;
		if (k == 3)
			s->within[s->nwithin++] = point[i];
		else
			s->on[s->non++] = (EdgePoint){ 3*point[i].triangle + k, point[i].w[(k+1)%3] };
	}
	qsort(s->within, s->nwithin, sizeof *s->within, by_triangle);
	s->non = sort_edge_points(d, s->non, s->on);
	return 0;
}
