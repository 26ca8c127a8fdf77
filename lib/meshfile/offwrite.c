/* offwrite.c - a mesh as the bytes of an OFF file. */
#include <stdio.h>

#include "writepriv.h"

int
off_write(Text *t, const Soup *s)
{
	const int *v;
	int f, i, n;

	if (!text_room(t))
		return MESH_ENOMEM;
	t->n += (size_t)snprintf(t->p + t->n, TEXT_MAX, "OFF\n%d %d 0\n", s->nv, s->nf);
	if (text_lines(t, s->xyz, s->nv, 3, ""))
		return MESH_ENOMEM;
	for (f = 0; f < s->nf; f++) {
		n = text_corners(s, f, &v);
		for (i = -1; i < n; i++) {
			if (!text_room(t))
				return MESH_ENOMEM;
			text_int(t, i < 0 ? n : v[i]);
			text_words(t, i < n - 1 ? " " : "\n");
		}
	}
	return 0;
}
