/* pocket.c - floods the part of a disk behind each inner edge between vertices of one side. */
#include <stdlib.h>

#include "pocket.h"
#include "../mesh/topology.h"

/* Whether side h of a triangle of the pocket is the edge that closes it: from a later to an earlier
 * vertex of side k of the rectangle.  rank: [nv] indices into the loop. */
static int
closes(const Disk *d, const int corner[4], const int *rank, int k, int h)
{
	int from = rank[d->m.tri[h]], to = rank[d->m.tri[topology_next(h)]];

	return (from - corner[k] + d->nb)%d->nb > (to - corner[k] + d->nb)%d->nb;
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

int
pocket_sides(const Disk *d, const int corner[4], unsigned char *side)
{
	int *rank = malloc(d->m.nv*sizeof *rank), *stack = malloc(d->m.nf*sizeof *stack), i, k, h;
	unsigned char *seen = calloc(d->m.nf, 1), *given = malloc(d->m.nv);
	int e = rank && stack && seen && given ? 0 : POCKET_ENOMEM;

	for (i = 0; !e && i < d->m.nv; i++)
		given[i] = side[i];
	for (i = 0; !e && i < d->nb; i++)
		rank[d->loop[i]] = i;
	for (h = 0; !e && h < 3*d->m.nf; h++)
		for (k = 0; d->twin[h] >= 0 && k < 4; k++)
			if (given[d->m.tri[h]] & given[d->m.tri[topology_next(h)]] & 1 << k
			    && !(seen[h/3] & 1 << k) && closes(d, corner, rank, k, h))
				flood(d, h, 1 << k, seen, stack, side);
	free(rank);
	free(stack);
	free(seen);
	free(given);
	return e;
}
