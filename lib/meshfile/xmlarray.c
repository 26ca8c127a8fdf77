/* xmlarray.c - arrays of numbers in XML: text, base64 or raw bytes, plain or packed by zlib. */
#include <limits.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

#include "xml.h"

/* Bytes of an array that are still to be read. */
typedef struct Source {
	Reader *r;
	const char *what;       /* the array, for messages */
	const char *p, *end;
	int base64;
} Source;

static int
ends_early(const Source *s)
{
	return mesh_fail(s->r->s->err, MESH_EFORMAT, "%s: data end early", s->what);
}

/* Copies the next n bytes to out; of base64 a run of its own, with = at its end. */
static int
get(Source *s, size_t n, char *out)
{
	if (s->base64)
		return base64_read(s->r, s->what, &s->p, s->end, n, out);
	if ((size_t)(s->end - s->p) < n)
		return ends_early(s);
	memcpy(out, s->p, n);
	s->p += n;
	return 0;
}

/* The most bytes that the source can still give. */
static size_t
most_bytes(const Source *s)
{
	const size_t n = (size_t)(s->end - s->p);

	return s->base64 ? n/4*3 : n;
}

/* Unpacks the n bytes of zlib data `in` to `out`; an error unless they are all used and give `want` bytes. */
static int
unpack(const Source *s, const char *in, size_t n, char *out, size_t want)
{
	z_stream z;
	int e;

	memset(&z, 0, sizeof z);
	if (n > UINT_MAX || want > UINT_MAX)
		return mesh_fail(s->r->s->err, MESH_EFORMAT, "%s: more than %u bytes in one piece", s->what, UINT_MAX);
	if (inflateInit2(&z, 15 + 32) != Z_OK)          /* +32: zlib or gzip */
		return mesh_fail(s->r->s->err, MESH_ENOMEM, "no memory to unpack zlib data");
	z.next_in = (Bytef *)(uintptr_t)in;
	z.avail_in = (uInt)n;
	z.next_out = (Bytef *)out;
	z.avail_out = (uInt)want;
	e = inflate(&z, Z_FINISH);
	inflateEnd(&z);
	if (e == Z_MEM_ERROR)
		return mesh_fail(s->r->s->err, MESH_ENOMEM, "no memory to unpack zlib data");
	if (e == Z_STREAM_END && z.avail_out == 0)
		return 0;
	return mesh_fail(s->r->s->err, MESH_EFORMAT, "%s: zlib data are damaged, or not of %zu bytes", s->what, want);
}

/* A zlib stream that takes all bytes left. */
static int
zlib_stream(Source *s, char *out, size_t want)
{
	size_t n = 0, k;
	const char *p;
	char *in;
	int e;

	for (p = s->p; p < s->end; p++)
		n += *p && !strchr(" \t\r\n=", *p);
	n = n*3/4;
	if (!(in = mesh_alloc(s->r->s->err, n, 1)))
		return MESH_ENOMEM;
	k = n;
	if ((e = get(s, k, in)) == 0)
		e = unpack(s, in, n, out, want);
	free(in);
	return e;
}

/* The integers before VTK's packed bytes: their number of blocks, the size of a block and of the last one if it
 * is smaller, the packed size of each. */
static int
blocks(Source *s, int size, int big, char *out, size_t want)
{
	Source ahead = *s;
	char first[8], *h = NULL, *in = NULL;
	unsigned long long n, each, last, i, packed, unpacked = 0, whole;
	int e;

	if ((e = get(&ahead, (size_t)size, first)) != 0)
		return e;
	n = scan_bytes(first, size, big);
	if (n > most_bytes(s)/(size_t)size)
		return ends_early(s);
	if (!(h = mesh_alloc(s->r->s->err, (size_t)n + 3, (size_t)size)))
		return MESH_ENOMEM;
	e = get(s, ((size_t)n + 3)*(size_t)size, h);
	each = e ? 0 : scan_bytes(h + size, size, big);
	last = e ? 0 : scan_bytes(h + 2*size, size, big);
	/* All blocks are one run of base64. */
	for (packed = 0, i = 0; !e && i < n; i++)
		if ((packed += scan_bytes(h + (3 + i)*(size_t)size, size, big)) > most_bytes(s))
			e = ends_early(s);
	if (!e && !(in = mesh_alloc(s->r->s->err, (size_t)packed, 1)))
		e = MESH_ENOMEM;
	if (!e)
		e = get(s, (size_t)packed, in);
	for (packed = 0, i = 0; !e && i < n; i++) {
		const unsigned long long k = scan_bytes(h + (3 + i)*(size_t)size, size, big);

		whole = i == n - 1 && last ? last : each;
		if (whole > want - unpacked)
			e = mesh_fail(s->r->s->err, MESH_EFORMAT, "%s: blocks of more than %zu bytes", s->what, want);
		else
			e = unpack(s, in + packed, (size_t)k, out + unpacked, (size_t)whole);
		packed += k;
		unpacked += whole;
	}
	if (!e && unpacked != want)
		e = mesh_fail(s->r->s->err, MESH_EFORMAT, "%s: blocks of %llu bytes, need %zu", s->what, unpacked, want);
	free(in);
	free(h);
	return e;
}

/* Plain bytes, of VTK after an integer, their number. */
static int
plain(Source *s, const XmlArray *a, char *out, size_t want)
{
	Source ahead = *s;
	char head[8], *both;
	unsigned long long n;
	int e;

	if (!a->head) {
		if ((e = want > most_bytes(s) ? ends_early(s) : get(s, want, out)) != 0)
			return e;
		return s->p == s->end ? 0 : mesh_fail(s->r->s->err, MESH_EFORMAT, "%s: more than %zu bytes", s->what, want);
	}
	if ((e = get(&ahead, (size_t)a->head, head)) != 0)
		return e;
	n = scan_bytes(head, a->head, a->big);
	if (n != want)
		return mesh_fail(s->r->s->err, MESH_EFORMAT, "%s: has %llu bytes, need %zu", s->what, n, want);
	if (!s->base64) {
		s->p = ahead.p;
		return get(s, want, out);
	}
	if (!(both = mesh_alloc(s->r->s->err, want + (size_t)a->head, 1)))
		return MESH_ENOMEM;
	if ((e = get(s, want + (size_t)a->head, both)) == 0)
		memcpy(out, both + a->head, want);
	free(both);
	return e;
}

static void
convert(const XmlArray *a, const char *p, long long n, double *x)
{
	unsigned long long w;
	long long i;

	for (i = 0; i < n; i++, p += a->size)
		if (a->kind == 'f') {
			x[i] = scan_float(p, a->size, a->big);
		} else {
			w = scan_bytes(p, a->size, a->big);
			x[i] = a->kind == 'u' ? (double)w : a->size == 4 ? (double)(int32_t)(uint32_t)w : (double)(int64_t)w;
		}
}

static int
text_numbers(Reader *r, const XmlArray *a, const char *what, long long n, double *x)
{
	const Token t = xml_plain(a->text);
	Reader at = { .p = t.s, .end = t.s + t.n, .line = 1, .s = r->s };
	char show[SCAN_SHOW];
	Token word;
	long long i;

	for (i = 0; scan_token(&at, &word); i++) {
		if (i == n)
			return mesh_fail(r->s->err, MESH_EFORMAT, "%s: more than %lld numbers", what, n);
		if (!scan_number(word, &x[i]))
			return mesh_fail(r->s->err, MESH_EFORMAT, "%s: '%s' is not a number", what, scan_show(word, show));
	}
	return i == n ? 0 : mesh_fail(r->s->err, MESH_EFORMAT, "%s: data end after %lld of %lld numbers", what, i, n);
}

static int
byte_numbers(Reader *r, const XmlArray *a, const char *what, long long n, double *x)
{
	const Token t = a->coding == XML_BASE64 ? xml_plain(a->text) : a->text;
	const size_t want = (size_t)n*(size_t)a->size;
	Source s = { r, what, t.s, t.s + t.n, a->coding == XML_BASE64 };
	char *bytes = mesh_alloc(r->s->err, want, 1);
	int e;

	if (!bytes)
		return MESH_ENOMEM;
	if (want == 0 && t.n == 0)
		e = 0;
	else if (a->packing == XML_ZLIB)
		e = zlib_stream(&s, bytes, want);
	else if (a->packing == XML_BLOCKS)
		e = blocks(&s, a->head, a->big, bytes, want);
	else
		e = plain(&s, a, bytes, want);
	if (!e && (size_t)(s.p - t.s) > r->unused)
		e = mesh_fail(r->s->err, MESH_EFORMAT, "%s: arrays share their bytes", what);
	if (!e) {
		r->unused -= (size_t)(s.p - t.s);
		convert(a, bytes, n, x);
	}
	free(bytes);
	return e;
}

double *
xmlarray_numbers(Reader *r, const XmlArray *a, const char *what, long long n, int *e)
{
	const size_t left = a->text.n, packed = left > r->most/1100 ? r->most : 1100*left + 4096;
	const size_t room = a->coding == XML_ASCII ? (left + 1)/2 :
	    (a->packing == XML_PLAIN ? left : packed < r->most ? packed : r->most)/(size_t)(a->size ? a->size : 8);
	double *x;

	if (!a->size || !a->text.s) {
		*e = mesh_fail(r->s->err, MESH_EFORMAT, "no array of %s", what);
		return NULL;
	}
	if ((*e = soup_check_count(r, what, n, room)) != 0)
		return NULL;
	if (!(x = mesh_alloc(r->s->err, (size_t)n, sizeof *x))) {
		*e = MESH_ENOMEM;
		return NULL;
	}
	*e = (a->coding == XML_ASCII ? text_numbers : byte_numbers)(r, a, what, n, x);
	if (*e) {
		free(x);
		return NULL;
	}
	return x;
}
