/* plywrite.c - a mesh as the bytes of a binary PLY file. */
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "../mesh/channel.h"
#include "writepriv.h"

static void
doubles(Text *t, const double *x, int n)
{
	uint64_t w;
	int c;

	for (c = 0; c < n; c++) {
		memcpy(&w, &x[c], 8);
		text_bytes(t, w, 8);
	}
}

/* The size in bytes, 1 or 4, of the field that holds the number of corners of a face. */
static int
countsize(const Soup *s)
{
	const int *v;
	int f;

	for (f = 0; f < s->nf; f++)
		if (text_corners(s, f, &v) > 255)
			return 4;
	return 1;
}

static const char OFFSET[] = "property double offset_u\nproperty double offset_v\n"
	"property double offset_n\nproperty double offset_r\n";

static void
plyhead(Text *t, const Soup *s, int uv, int offset, int size)
{
	text_words(t, "ply\nformat binary_little_endian 1.0\n");
	text_modulus(t, s, "comment ");
	t->n += (size_t)snprintf(t->p + t->n, TEXT_MAX, "element vertex %d\n"
	    "property double x\nproperty double y\nproperty double z\n%s%s"
	    "element face %d\nproperty list %s int vertex_indices\nend_header\n", s->nv,
	    uv ? "property double s\nproperty double t\n" : "", offset ? OFFSET : "", s->nf,
	    size > 1 ? "int" : "uchar");
}

int
ply_write(Text *t, const Soup *s)
{
	const double *uv = channel_values(&s->channels, MESH_UV);
	const double *offset = channel_values(&s->channels, MESH_OFFSET);
	const int size = countsize(s), *v;
	int f, i, n;

	if (!text_room(t))
		return MESH_ENOMEM;
	plyhead(t, s, uv != NULL, offset != NULL, size);
	for (i = 0; i < s->nv; i++) {
		if (!text_room(t))
			return MESH_ENOMEM;
		doubles(t, s->xyz + 3*(size_t)i, 3);
		if (uv)
			doubles(t, uv + 2*(size_t)i, 2);
		if (offset)
			doubles(t, offset + 4*(size_t)i, 4);
	}
	for (f = 0; f < s->nf; f++) {
		n = text_corners(s, f, &v);
		for (i = -1; i < n; i++) {
			if (!text_room(t))
				return MESH_ENOMEM;
			text_bytes(t, (uint64_t)(i < 0 ? n : v[i]), i < 0 ? size : 4);
		}
	}
	return 0;
}
