/* longestside.c - the sides that longest-edge bisection cuts. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "longestside.h"
#include "topology.h"
#include "../base/vec3.h"

static const double EQUAL = 1e-9;       /* relative difference that counts as equal */

static double
length(const Disk *d, int side)
{
	double e[3];

	sub3(&d->m.xyz[3*(size_t)d->m.tri[topology_next(side)]], &d->m.xyz[3*(size_t)d->m.tri[side]], e);
	return norm3(e);
}

static int
edge_of_side(const Disk *d, int side)
{
	return d->twin[side] >= 0 && d->twin[side] < side ? d->twin[side] : side;
}

/* Whether side a is to be chosen rather than side b of the same length. */
static int
is_preferred(const Disk *d, const double *key, int a, int b)
{
	double x = 0, y = 0;

	if (key) {
		x = key[d->m.tri[a]] + key[d->m.tri[topology_next(a)]];
		y = key[d->m.tri[b]] + key[d->m.tri[topology_next(b)]];
	}
	if (fabs(x - y) > EQUAL*fabs(x))
		return x > y;
	return edge_of_side(d, a) < edge_of_side(d, b);
}

int
longest_side(const Disk *d, const double *key, int f)
{
	double l[3], longest;
	int k, best = -1;

	for (k = 0; k < 3; k++)
		l[k] = length(d, 3*f + k);
	longest = fmax(l[0], fmax(l[1], l[2]));
	for (k = 0; k < 3; k++)
		if (l[k] >= longest*(1 - EQUAL) && (best < 0 || is_preferred(d, key, 3*f + k, best)))
			best = 3*f + k;
	return best;
}

/* Faces whose longest side may have to be cut. */
typedef struct Stack {
	int *face, n;
} Stack;

/* Marks a side as cut, in both its faces, and pushes the neighbour to be checked. */
static void
cut_side(const Disk *d, int side, int *cut, Stack *s)
{
	int twin = d->twin[side];

	if (cut[side] == SIDE_CUT)
		return;
	cut[side] = SIDE_CUT;
	if (twin >= 0) {
		cut[twin] = SIDE_CUT;
		s->face[s->n++] = twin/3;
	}
}

/* Each side is cut once, so the stack holds at most one entry for each side. */
int
cut_sides(const Disk *d, const unsigned char *marked, const double *key, int *cut)
{
	size_t sides = 3*(size_t)d->m.nf;
	Stack s = { malloc(sides*sizeof *s.face), 0 };
	int f, k;

	if (!s.face)
		return MESH_ENOMEM;
	memset(cut, -1, sides*sizeof *cut);
	for (f = 0; f < d->m.nf; f++)
		for (k = 0; k < 3 && (!marked || marked[f]); k++)
			cut_side(d, 3*f + k, cut, &s);
	while (s.n > 0)
		cut_side(d, longest_side(d, key, s.face[--s.n]), cut, &s);
	free(s.face);
	return 0;
}
