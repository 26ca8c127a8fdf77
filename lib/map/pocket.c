/* pocket.c - floods the part of a disk behind each inner edge between vertices of one side. */
#include <math.h>
#include <stdlib.h>

#include "pocket.h"
#include "../mesh/topology.h"

/* The loop, and what it is mapped to: the rectangle with these corners, or the boundary of a sock with
 * the vertices at these places. */
typedef struct Loop {
	const Disk   *d;
	int          *rank;             /* [nv] indices into the loop */
	const int    *corner;
	const double *place;            /* [nv][2] */
} Loop;

/* Whether side h of a triangle of the pocket is the edge that closes it: from a later to an earlier
 * vertex of side k of the rectangle.  On a sock, where u falls along the loop, the part behind the edge
 * must take less of the boundary than the other part. */
static int
closes(const Loop *l, int k, int h)
{
	const Disk *d = l->d;
	int p = d->m.tri[h], q = d->m.tri[topology_next(h)], from = l->rank[p], to = l->rank[q];
	double step;

	if (l->corner)
		return (from - l->corner[k] + d->nb)%d->nb > (to - l->corner[k] + d->nb)%d->nb;
	step = l->place[2*(size_t)q] - l->place[2*(size_t)p];
	return step - floor(step) < 0.5;
}

/* Adds `bit` to the vertices of the triangles behind side h.  seen: [nf], has `bit` where a triangle
 * was reached; stack: [nf] */
static void
flood(const Disk *d, int h, int bit, unsigned char *seen, int *stack, unsigned char *side)
{
	int n = 0, f, k, twin;

	stack[n++] = h/3;
	seen[h/3] |= bit;
	while (n > 0)
		for (f = stack[--n], k = 0; k < 3; k++) {
			side[d->m.tri[3*f+k]] |= bit;
			twin = 3*f + k == h ? -1 : d->twin[3*f+k];
			if (twin >= 0 && !(seen[twin/3] & bit)) {
				seen[twin/3] |= bit;
				stack[n++] = twin/3;
			}
		}
}

static int
find(Loop *l, unsigned char *side)
{
	const Disk *d = l->d;
	int *stack = malloc(d->m.nf*sizeof *stack), i, k, h;
	unsigned char *seen = calloc(d->m.nf, 1), *given = malloc(d->m.nv);
	int e;

	l->rank = malloc(d->m.nv*sizeof *l->rank);
	e = l->rank && stack && seen && given ? 0 : POCKET_ENOMEM;
	for (i = 0; !e && i < d->m.nv; i++)
		given[i] = side[i];
	for (i = 0; !e && i < d->nb; i++)
		l->rank[d->loop[i]] = i;
	for (h = 0; !e && h < 3*d->m.nf; h++)
		for (k = 0; d->twin[h] >= 0 && k < 4; k++)
			if (given[d->m.tri[h]] & given[d->m.tri[topology_next(h)]] & 1 << k
			    && !(seen[h/3] & 1 << k) && closes(l, k, h))
				flood(d, h, 1 << k, seen, stack, side);
	free(l->rank);
	free(stack);
	free(seen);
	free(given);
	return e;
}

int
pocket_sides(const Disk *d, const int corner[4], unsigned char *side)
{
	Loop l = { .d = d, .corner = corner };

	return find(&l, side);
}

int
pocket_round(const Disk *d, const double *place, unsigned char *side)
{
	Loop l = { .d = d, .place = place };

	return find(&l, side);
}
