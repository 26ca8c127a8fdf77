/* loop.c - boundary loops: where they begin, how long they are. */
#include <stdlib.h>
#include <string.h>

#include "../mesh/fail.h"
#include "area.h"
#include "loop.h"

int
loop_next(const Sheet *s, int side)
{
	for (side = sheet_next(side); s->twin[side] >= 0; side = sheet_next(s->twin[side]))
		continue;
	return side;
}

Loop
loop_at(const Sheet *s, int side)
{
	const int start = side;
	Loop l = { side, 0, 0 };

	do {
		l.n++;
		l.length += sheet_length(s, side);
		if (s->tri[side] < s->tri[l.side])
			l.side = side;
		side = loop_next(s, side);
	} while (side != start);
	return l;
}

static void
mark(const Sheet *s, int side, unsigned char *seen)
{
	for (; !seen[side]; side = loop_next(s, side))
		seen[side] = 1;
}

static int
by_vertex(const void *a, const void *b)
{
	const int *x = a, *y = b;

	return x[0] < y[0] ? -1 : x[0] > y[0];
}

int
loop_find(const Sheet *s, Loop **loop)
{
	unsigned char *seen = mesh_alloc(s->err, 3*(size_t)s->nf, 1);
	int i, k, sides = 0, n = MESH_ENOMEM, (*start)[2];

	for (i = 0; i < 3*s->nf; i++)
		sides += s->twin[i] < 0;
	*loop = mesh_alloc(s->err, (size_t)sides, sizeof **loop);
	start = mesh_alloc(s->err, (size_t)sides, sizeof *start);
	if (seen && *loop && start) {
		memset(seen, 0, 3*(size_t)s->nf);
		for (k = 0, i = 0; i < 3*s->nf; i++)
			if (s->twin[i] < 0)
				start[k][0] = s->tri[i], start[k++][1] = i;
		qsort(start, (size_t)sides, sizeof *start, by_vertex);
		for (n = 0, k = 0; k < sides; k++)
			if (!seen[start[k][1]]) {
				(*loop)[n++] = loop_at(s, start[k][1]);
				mark(s, start[k][1], seen);
			}
	} else {
		free(*loop);
		*loop = NULL;
	}
	free(seen);
	free(start);
	return n;
}
