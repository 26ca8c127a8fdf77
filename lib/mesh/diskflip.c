/* diskflip.c - reversing the orientation of a disk. */
#include "disk.h"
#include "../base/vec3.h"

/* The number that a side has after its face is turned. */
static int
flipped(int side)
{
	return side < 0 ? side : side - side%3 + (2 - side%3);
}

void
disk_flip(Disk *d)
{
	int f, i, t;

	for (f = 0; f < d->m.nf; f++) {
		int *c = d->m.tri + 3*(size_t)f, *twin = d->twin + 3*(size_t)f;

		t = c[1], c[1] = c[2], c[2] = t;
		t = twin[0], twin[0] = flipped(twin[2]), twin[2] = flipped(t);
		twin[1] = flipped(twin[1]);
	}
	for (i = 1; i < d->nb - i; i++)
		t = d->loop[i], d->loop[i] = d->loop[d->nb - i], d->loop[d->nb - i] = t;
}

/* Six times the volume inside a closed surface; negative if its faces are clockwise seen from outside. */
static double
volume(const Mesh *m)
{
	double a[3], b[3], c[3], n[3], sum = 0;
	int t;

	for (t = 0; t < m->nf; t++) {
		const int *corner = &m->tri[3*(size_t)t];

		sub3(&m->xyz[3*(size_t)corner[0]], m->xyz, a);
		sub3(&m->xyz[3*(size_t)corner[1]], m->xyz, b);
		sub3(&m->xyz[3*(size_t)corner[2]], m->xyz, c);
		cross3(b, c, n);
		sum += dot3(a, n);
	}
	return sum;
}

int
disk_turn_outwards(Disk *d)
{
	int inwards = volume(&d->m) < 0;

	if (inwards)
		disk_flip(d);
	return inwards;
}
