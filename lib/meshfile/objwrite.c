/* objwrite.c - a mesh as the bytes of an OBJ file. */
#include "../mesh/channel.h"
#include "objtexture.h"

static int
objface(Text *t, const Soup *s, int f, int with_uv, const ObjTexture *images)
{
	const int *v, *vt;
	int i, n = text_corners(s, f, &v), own[OBJTEXTURE_CORNERS];

	vt = v;
	if (n <= OBJTEXTURE_CORNERS) {
		objtexture_face(images, s, n, v, own);
		vt = own;
	}
	for (i = -1; i < n; i++) {
		if (!text_room(t))
			return MESH_ENOMEM;
		text_words(t, i < 0 ? "f" : " ");
		if (i >= 0)
			text_int(t, v[i] + 1);
		if (i >= 0 && with_uv) {
			text_words(t, "/");
			text_int(t, vt[i] + 1);
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
	ObjTexture images;
	int f, e;

	if (!text_room(t) || objtexture_init(&images, s))
		return MESH_ENOMEM;
	text_modulus(t, s, "# ");
	e = text_facts(t, s, "# ");
	if (!e)
		e = text_lines(t, s->xyz, s->nv, 3, "v ");
	if (!e && uv)
		e = text_lines(t, uv, s->nv, 2, "vt ");
	if (!e)
		e = objtexture_lines(&images, t, s);
	if (!e && offset)               /* as comments: others may take numbers for a colour */
		e = text_lines(t, offset, s->nv, 4, "# lhgrid offset ");
	for (f = 0; !e && f < s->nf; f++)
		e = objface(t, s, f, uv != NULL, &images);
	objtexture_free(&images);
	return e;
}
