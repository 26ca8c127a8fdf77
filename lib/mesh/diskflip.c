/* diskflip.c - reversing the orientation of a disk. */
#include "disk.h"

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
