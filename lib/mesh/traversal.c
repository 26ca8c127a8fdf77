/* traversal.c - breadth-first search over the faces of a disk. */
#include <stdlib.h>
#include <string.h>

#include "topology.h"
#include "traversal.h"

/* The sides of the given disk, each the first side of its face, by which faces are reached. */
typedef struct Queue {
	int *entry, n;
	int *place;             /* [3*nf] the number in the new disk of each side; -1: not reached */
} Queue;

static void
reach(Queue *q, int side)
{
	int k;

	if (side < 0 || q->place[side] >= 0)
		return;
	for (k = 0; k < 3; k++, side = topology_next(side)) {
		q->place[side] = 3*q->n + k;
		if (k == 0)
			q->entry[q->n] = side;
	}
	q->n++;
}

/* The boundary side that starts at vertex i. */
static int
boundary_side(const Disk *d, int i)
{
	int h = 0;

	while (d->twin[h] >= 0 || d->m.tri[h] != i)
		h++;
	return h;
}

static void
search(const Disk *d, int first, Queue *q)
{
	int f, k, h;

	memset(q->place, -1, 3*(size_t)d->m.nf*sizeof *q->place);
	reach(q, first);
	for (f = 0; f < q->n; f++)
		for (k = 0, h = q->entry[f]; k < 3; k++, h = topology_next(h))
			reach(q, d->twin[h]);
}

/* Numbers the vertices in the order of the faces, and fills in the new disk. */
static void
number(const Disk *d, const Queue *q, int start, Traversal *t)
{
	int f, k, h, i, n = 0;

	memset(t->number, -1, d->m.nv*sizeof *t->number);
	for (f = 0; f < d->m.nf; f++)
		for (k = 0, h = q->entry[f]; k < 3; k++, h = topology_next(h)) {
			int *to = &t->number[d->m.tri[h]];

			if (*to < 0)
				*to = n++;
			t->d.m.tri[3*(size_t)f + k] = *to;
			t->d.twin[3*(size_t)f + k] = d->twin[h] < 0 ? -1 : q->place[d->twin[h]];
		}
	for (i = 0; i < d->m.nv; i++)
		memcpy(&t->d.m.xyz[3*(size_t)t->number[i]], &d->m.xyz[3*(size_t)i], 3*sizeof *d->m.xyz);
	for (i = 0; i < d->nb; i++)
		t->d.loop[i] = t->number[d->loop[(start + i)%d->nb]];
}

int
traversal_init(Traversal *t, const Disk *given, int start)
{
	size_t nv = given->m.nv, nf = given->m.nf;
	Queue q = { malloc(nf*sizeof *q.entry), 0, malloc(3*nf*sizeof *q.place) };
	int e = MESH_ENOMEM;

	*t = (Traversal){ .d = { .m = { .nv = given->m.nv, .nf = given->m.nf }, .nb = given->nb } };
	t->d.m.xyz = malloc(3*nv*sizeof *t->d.m.xyz);
	t->d.m.tri = malloc(3*nf*sizeof *t->d.m.tri);
	t->d.twin = malloc(3*nf*sizeof *t->d.twin);
	t->d.loop = malloc(given->nb*sizeof *t->d.loop);
	t->number = malloc(nv*sizeof *t->number);
	if (q.entry && q.place && t->d.m.xyz && t->d.m.tri && t->d.twin && t->d.loop && t->number) {
		search(given, boundary_side(given, given->loop[start]), &q);
		number(given, &q, start, t);
		e = 0;
	}
	free(q.entry);
	free(q.place);
	if (e)
		traversal_free(t);
	return e;
}

void
traversal_free(Traversal *t)
{
	disk_free(&t->d);
	free(t->number);
	t->number = NULL;
}
