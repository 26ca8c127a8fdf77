/* splitting.c - splits triangles of a disk at new vertices. */
#include <string.h>

#include "splitting.h"
#include "topology.h"

/* Moves side `from` to number `to`, with its twin, its flag in `inner` and the next point on it. */
static void
move_side(const Splitting *s, int from, int to)
{
	Disk *d = s->d;

	d->twin[to] = d->twin[from];
	if (d->twin[to] >= 0)
		d->twin[d->twin[to]] = to;
	if (s->inner)
		s->inner[to] = s->inner[from];
	s->line[to] = s->line[from];
	s->line[from] = -1;
	if (s->line[to] >= 0)
		s->side[s->line[to]] = to;
}

/* Splits the triangle of side h at vertex m on that side into (a,m,c), which keeps its number, and
 * (m,b,c), which becomes triangle f. */
static void
split_triangle(const Splitting *s, int h, int m, int f)
{
	Disk *d = s->d;
	int next = topology_next(h), last = topology_next(next), *t = &d->m.tri[3*(size_t)f];

	t[0] = m;
	t[1] = d->m.tri[next];
	t[2] = d->m.tri[last];
	d->m.tri[next] = m;
	s->line[3*f] = s->line[3*f+2] = -1;
	move_side(s, next, 3*f + 1);
	if (s->inner) {
		s->inner[3*f] = s->inner[h];
		s->inner[next] = s->inner[3*f+2] = 1;
	}
	d->twin[next] = 3*f + 2;
	d->twin[3*f+2] = next;
}

int
splitting_edge(const Splitting *s, int h, int m)
{
	Disk *d = s->d;
	int g = d->twin[h], f = d->m.nf++, a = d->m.tri[h];

	split_triangle(s, h, m, f);
	if (g < 0) {
		d->twin[3*f] = -1;
		s->after[m] = s->after[a];
		s->after[a] = m;
		d->nb++;
		return 3*f;
	}
	split_triangle(s, g, m, d->m.nf++);
	d->twin[3*f] = g;
	d->twin[g] = 3*f;
	d->twin[h] = 3*(f + 1);
	d->twin[3*(f+1)] = h;
	return 3*f;
}

void
splitting_face(const Splitting *s, int f, int m)
{
	Disk *d = s->d;
	int g[3] = { f, d->m.nf, d->m.nf + 1 }, c[3], k;

	memcpy(c, &d->m.tri[3*(size_t)f], sizeof c);
	d->m.nf += 2;
	move_side(s, 3*f + 1, 3*g[1]);
	move_side(s, 3*f + 2, 3*g[2]);
	for (k = 0; k < 3; k++) {
		int side = 3*g[k], *t = &d->m.tri[side];

		t[0] = c[k];
		t[1] = c[(k+1)%3];
		t[2] = m;
		d->twin[side+1] = 3*g[(k+1)%3] + 2;
		d->twin[side+2] = 3*g[(k+2)%3] + 1;
		s->line[side+1] = s->line[side+2] = -1;
		if (s->inner)
			s->inner[side+1] = s->inner[side+2] = 1;
	}
}

void
splitting_write_loop(const Splitting *s)
{
	Disk *d = s->d;
	int i;

	for (i = 1; i < d->nb; i++)
		d->loop[i] = s->after[d->loop[i-1]];
}
