/* plywrite.c - a mesh as the bytes of a binary PLY file. */
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "../mesh/channel.h"
#include "plypriv.h"
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

/* Which optional properties the file has; fields are all other channels. */
typedef struct Has {
	const double *uv, *offset, *source;
	int           colours;  /* fields red, green and blue, which viewers know as bytes */
} Has;

static int
is_field(const Channel *c)
{
	return strcmp(c->name, MESH_UV) != 0 && strcmp(c->name, MESH_OFFSET) != 0 && strcmp(c->name, MESH_SOURCE) != 0;
}

/* The type that a field is written as. */
static const PlyType *
type_of(const Has *has, const Channel *c)
{
	return ply_type(c->type != CHANNEL_ANY ? c->type : has->colours && channel_colour(c) ? CHANNEL_UINT8 : CHANNEL_DOUBLE);
}

/* x as that type; the nearest number that it holds, 0 for NaN. */
static void
typed(Text *t, const PlyType *type, double x)
{
	const int bits = 8*type->size - (type->kind == 'i');
	const double most = ldexp(1, bits) - 1;
	uint32_t w;
	float y;

	if (type->kind != 'f') {
		x = isnan(x) ? 0 : fmin(fmax(rint(x), type->kind == 'i' ? -most - 1 : 0), most);
		text_bytes(t, (uint64_t)(int64_t)x, type->size);
	} else if (type->size == 4) {
		y = fabs(x) <= (double)FLT_MAX || !isfinite(x) ? (float)x : (float)copysign(FLT_MAX, x);
		memcpy(&w, &y, 4);
		text_bytes(t, w, 4);
	} else
		doubles(t, &x, 1);
}

/* A property for each number of a field: NAME, or NAME_0 NAME_1 .. */
static int
field_properties(Text *t, const Has *has, const Channels *c)
{
	int k, i;

	for (k = 0; k < c->n; k++)
		for (i = 0; i < c->channel[k].n && is_field(&c->channel[k]); i++) {
			if (!text_room(t))
				return MESH_ENOMEM;
			t->n += (size_t)snprintf(t->p + t->n, TEXT_MAX, "property %s %s",
			    type_of(has, &c->channel[k])->name, c->channel[k].name);
			if (c->channel[k].n > 1)
				t->n += (size_t)snprintf(t->p + t->n, TEXT_MAX/2, "_%d", i);
			text_words(t, "\n");
		}
	return 0;
}

/* The lines of the remarks as comments.  Returns 0 or MESH_ENOMEM. */
static int
remarks(Text *t, const char *line)
{
	int n;

	for (; line && *line; line += n + (line[n] == '\n')) {
		n = (int)strcspn(line, "\n");
		if (!text_room(t))
			return MESH_ENOMEM;
		t->n += (size_t)snprintf(t->p + t->n, TEXT_MAX, "comment %.*s\n", n < 300 ? n : 300, line);
	}
	return text_room(t) ? 0 : MESH_ENOMEM;
}

static int
plyhead(Text *t, const Soup *s, const Has *has, int size)
{
	t->n += (size_t)snprintf(t->p + t->n, TEXT_MAX, "element vertex %d\n"
	    "property double x\nproperty double y\nproperty double z\n%s%s%s", s->nv,
	    has->uv ? "property double s\nproperty double t\n" : "", has->offset ? OFFSET : "",
	    has->source ? "property int " MESH_SOURCE "\n" : "");
	if (field_properties(t, has, &s->channels) || !text_room(t))
		return MESH_ENOMEM;
	t->n += (size_t)snprintf(t->p + t->n, TEXT_MAX, "element face %d\nproperty list %s int vertex_indices\n%send_header\n",
	    s->nf, size > 1 ? "int" : "uchar", s->filled ? "property uchar filled\n" : "");
	return 0;
}

static int
plyvertex(Text *t, const Soup *s, const Has *has, int i)
{
	int k, j;

	if (!text_room(t))
		return MESH_ENOMEM;
	doubles(t, s->xyz + 3*(size_t)i, 3);
	if (has->uv)
		doubles(t, has->uv + 2*(size_t)i, 2);
	if (has->offset)
		doubles(t, has->offset + 4*(size_t)i, 4);
	if (has->source)
		text_bytes(t, (uint64_t)(int64_t)has->source[i], 4);
	for (k = 0; k < s->channels.n; k++) {
		const Channel *c = &s->channels.channel[k];

		if (!text_room(t))
			return MESH_ENOMEM;
		for (j = 0; j < c->n && is_field(c); j++)
			typed(t, type_of(has, c), c->f[(size_t)c->n*(size_t)i + (size_t)j]);
	}
	return 0;
}

static int
plyface(Text *t, const Soup *s, int f, int size)
{
	const int *v, n = text_corners(s, f, &v);
	int i;

	for (i = -1; i < n; i++) {
		if (!text_room(t))
			return MESH_ENOMEM;
		text_bytes(t, (uint64_t)(i < 0 ? n : v[i]), i < 0 ? size : 4);
	}
	if (s->filled)
		text_bytes(t, s->filled[f], 1);
	return 0;
}

int
ply_write(Text *t, const Soup *s)
{
	const Has has = { channel_values(&s->channels, MESH_UV), channel_values(&s->channels, MESH_OFFSET),
		channel_values(&s->channels, MESH_SOURCE), channel_find(&s->channels, "red") &&
		channel_find(&s->channels, "green") && channel_find(&s->channels, "blue") };
	const int size = countsize(s);
	int i, e = 0;

	if (!text_room(t))
		return MESH_ENOMEM;
	text_words(t, "ply\nformat binary_little_endian 1.0\n");
	text_modulus(t, s, "comment ");
	if (text_facts(t, s, "comment ") || remarks(t, s->remarks))
		return MESH_ENOMEM;
	e = plyhead(t, s, &has, size);
	for (i = 0; !e && i < s->nv; i++)
		e = plyvertex(t, s, &has, i);
	for (i = 0; !e && i < s->nf; i++)
		e = plyface(t, s, i, size);
	return e;
}
