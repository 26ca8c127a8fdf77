/* objwrite.c - a mesh as the bytes of an OBJ file. */
#include "../mesh/channel.h"
#include "writepriv.h"

static int
objface(Text *t, const Soup *s, int f, int with_uv)
{
	const int *v;
	int i, n = text_corners(s, f, &v);

	for (i = -1; i < n; i++) {
		if (!text_room(t))
			return MESH_ENOMEM;
		text_words(t, i < 0 ? "f" : " ");
		if (i >= 0)
			text_int(t, v[i] + 1);
		if (i >= 0 && with_uv) {
			text_words(t, "/");
			text_int(t, v[i] + 1);
		}
	}
	text_words(t, "\n");
	return 0;
}

int
obj_write(Text *t, const Soup *s)
{
	const double *uv = channel_values(&s->channels, MESH_UV);
	const double *offset = channel_values(&s->channels, MESH_OFFSET);
	int f, e;

	if (!text_room(t))
		return MESH_ENOMEM;
	text_modulus(t, s, "# ");
	if (text_facts(t, s, "# "))
		return MESH_ENOMEM;
	e = text_lines(t, s->xyz, s->nv, 3, "v ");
	if (!e && uv)
		e = text_lines(t, uv, s->nv, 2, "vt ");
	if (!e && offset)               /* as comments: others may take numbers for a colour */
		e = text_lines(t, offset, s->nv, 4, "# lhgrid offset ");
	for (f = 0; !e && f < s->nf; f++)
		e = objface(t, s, f, uv != NULL);
	return e;
}
