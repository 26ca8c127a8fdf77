/* filled.c - the faces of a soup that fill holes are dropped. */
#include <stdlib.h>
#include <string.h>

#include "channel.h"
#include "fail.h"
#include "filled.h"

/* Marks the vertices of filled faces by 1, those of others by 2. */
static void
mark(const Soup *s, unsigned char *of)
{
	int f, i;

	memset(of, 0, (size_t)s->nv);
	for (f = 0; f < s->nf; f++)
		for (i = s->first[f]; i < s->first[f+1]; i++)
			of[s->idx[i]] |= s->filled[f] ? 1 : 2;
}

/* Drops the marked faces; vertex v becomes to[v]. */
static int
keep_faces(Soup *s, const int *to)
{
	int f, i, n = 0, m = 0;
	const int all = s->nf;

	for (f = 0; f < all; f++) {
		const int begin = s->first[f], end = s->first[f+1];

		if (s->filled[f])
			continue;
		s->first[n++] = m;
		for (i = begin; i < end; i++)
			s->idx[m++] = to[s->idx[i]];
	}
	s->first[n] = m;
	s->nf = n;
	free(s->filled);
	s->filled = NULL;
	return all - n;
}

int
filled_drop(Soup *s)
{
	unsigned char *of;
	Channels kept = { 0 };
	int *to, *from, v, n = 0, e = MESH_ENOMEM;

	if (!s->filled)
		return 0;
	of = mesh_alloc(s->err, (size_t)s->nv, 1);
	to = mesh_alloc(s->err, (size_t)s->nv, sizeof *to);
	from = mesh_alloc(s->err, (size_t)s->nv, sizeof *from);
	if (of && to && from) {
		mark(s, of);
		for (v = 0; v < s->nv; v++) {
			to[v] = n;
			if (of[v] != 1)
				from[n++] = v;
		}
		e = channels_gather(&kept, &s->channels, n, from, 0);
	}
	if (!e) {
		channels_free(&s->channels);
		s->channels = kept;
		for (v = 0; v < n; v++)
			memmove(s->xyz + 3*(size_t)v, s->xyz + 3*(size_t)from[v], 3*sizeof *s->xyz);
		s->nv = n;
		e = keep_faces(s, to);
	}
	free(of);
	free(to);
	free(from);
	return e == MESH_ENOMEM ? mesh_fail(s->err, e, "no memory to drop the faces in holes") : e;
}
