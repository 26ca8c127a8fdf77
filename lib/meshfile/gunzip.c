/* gunzip.c - gzip data in memory. */
#include <limits.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

#include "meshpriv.h"

typedef struct Out {
	char  *p;
	size_t n, cap, max;
} Out;

/* The most bytes that n bytes of gzip data may unpack to.  deflate compresses by less than 1100:1,
 * so a larger result means a damaged file. */
static size_t
largest_output(size_t n, size_t most)
{
	return n > most / 1100 || 1100*n + 4096 > most ? most : 1100*n + 4096;
}

static int
grow(Out *o, char *err)
{
	size_t cap = o->cap < o->max / 2 ? 2*o->cap : o->max;
	char *p;

	if (o->cap == o->max)
		return mesh_fail(err, MESH_EFORMAT, "gzip data are larger than %zu bytes", o->max);
	p = realloc(o->p, cap);
	if (!p)
		return mesh_fail(err, MESH_ENOMEM, "no memory for %zu bytes", cap);
	o->p = p;
	o->cap = cap;
	return 0;
}

/* Calls inflate once and advances *in and o.  Returns 1 at the end of a gzip member, 0 if the
 * member continues, or a negative code. */
static int
inflate_some(z_stream *z, const char **in, const char *end, Out *o, char *err)
{
	const size_t left = (size_t)(end - *in), room = o->cap - o->n;
	int e;

	z->next_in = (Bytef *)(uintptr_t)*in;
	z->avail_in = left < UINT_MAX ? (uInt)left : UINT_MAX;
	z->next_out = (Bytef *)o->p + o->n;
	z->avail_out = room < UINT_MAX ? (uInt)room : UINT_MAX;
	e = inflate(z, Z_NO_FLUSH);
	*in = (const char *)z->next_in;
	o->n = (size_t)((char *)z->next_out - o->p);
	if (e == Z_STREAM_END)
		return 1;
	if (e == Z_MEM_ERROR)
		return mesh_fail(err, MESH_ENOMEM, "no memory to unpack gzip data");
	if (e != Z_OK && e != Z_BUF_ERROR)
		return mesh_fail(err, MESH_EFORMAT, "gzip data are damaged: %s",
		    z->msg ? z->msg : "no stream");
	if (*in == end && z->avail_out > 0)
		return mesh_fail(err, MESH_EFORMAT, "gzip data end early");
	return 0;
}

static int
inflate_members(z_stream *z, const char *in, const char *end, Out *o, char *err)
{
	int e;

	for (;;) {
		if (o->n == o->cap && (e = grow(o, err)) != 0)
			return e;
		if ((e = inflate_some(z, &in, end, o, err)) < 0)
			return e;
		if (e == 0)
			continue;
		while (in < end && *in == '\0')         /* zeros after a member are padding */
			in++;
		if (in == end)
			return 0;
		if (inflateReset(z) != Z_OK)
			return mesh_fail(err, MESH_EFORMAT, "gzip data are damaged");
	}
}

int
gunzip(const char *in, size_t n, size_t most, char **out, size_t *nout, char err[MESH_ERRLEN])
{
	Out o = { NULL, 0, 0, largest_output(n, most) };
	z_stream z;
	int e;

	memset(&z, 0, sizeof z);
	o.cap = n < o.max / 4 ? 4*n + 4096 : o.max;
	o.p = mesh_alloc(err, o.cap, 1);
	if (!o.p)
		return MESH_ENOMEM;
	if (inflateInit2(&z, 15 + 16) != Z_OK) {        /* +16: gzip, not zlib */
		free(o.p);
		return mesh_fail(err, MESH_ENOMEM, "no memory to unpack gzip data");
	}
	e = inflate_members(&z, in, in + n, &o, err);
	inflateEnd(&z);
	if (e) {
		free(o.p);
		return e;
	}
	*out = o.p;
	*nout = o.n;
	return 0;
}

size_t
gunzip_head(const char *in, size_t n, char *out, size_t room)
{
	z_stream z;

	memset(&z, 0, sizeof z);
	if (inflateInit2(&z, 15 + 16) != Z_OK)
		return 0;
	z.next_in = (Bytef *)(uintptr_t)in;
	z.avail_in = n < UINT_MAX ? (uInt)n : UINT_MAX;
	z.next_out = (Bytef *)out;
	z.avail_out = (uInt)room;
	inflate(&z, Z_NO_FLUSH);
	inflateEnd(&z);
	return room - z.avail_out;
}
