/* gltfdata.c - buffers and accessors of glTF. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "beside.h"
#include "gltfpriv.h"

long long
gltf_item(Gltf *g, int list, long long i)
{
	const GltfList *l = &g->list[list];

	if (i >= 0 && i < (long long)l->n)
		return l->item[i];
	mesh_fail(g->r->s->err, MESH_EFORMAT, "refers to number %lld of %s, there are %u", i, l->name, (unsigned)l->n);
	return -1;
}

static int
is_data(Token uri)
{
	return uri.n > 5 && memcmp(uri.s, "data:", 5) == 0;
}

/* Decodes a uri "data:..;base64,..". */
static int
embedded(Gltf *g, GltfBuffer *b, long long i, Token uri, long long n)
{
	const char *p = memchr(uri.s, ',', uri.n);

	if (!p)
		return mesh_fail(g->r->s->err, MESH_EFORMAT, "buffer %lld: its data: uri has no comma", i);
	p++;
	if ((size_t)n > uri.n/4*3)
		return mesh_fail(g->r->s->err, MESH_EFORMAT, "buffer %lld announces %lld bytes, has at most %zu", i, n, uri.n/4*3);
	if (!(b->own = mesh_alloc(g->r->s->err, (size_t)n, 1)))
		return MESH_ENOMEM;
	b->p = b->own;
	return base64_read(g->r, "buffer", &p, uri.s + uri.n, (size_t)n, b->own);
}

/* Whether the uri begins with a scheme, such as https: */
static int
has_scheme(const char *uri, long n)
{
	long i = 0;

	while (i < n && uri[i] && strchr("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+-.", uri[i]))
		i++;
	return i > 0 && i < n && uri[i] == ':';
}

/* Reads the file that the uri names, a path in which %20 is a blank. */
static int
external(Gltf *g, GltfBuffer *b, long long i, long long uri, long long n)
{
	char name[2000], what[40];
	long k, m = 0, size = json_unescaped(&g->j, uri, name, sizeof name), byte;
	char show[SCAN_SHOW];
	int e;

	if (size < 0 || has_scheme(name, size))
		return mesh_fail(g->r->s->err, MESH_EFORMAT, "buffer %lld has the uri '%s', which is neither data: nor the name of a "
		    "file", i, scan_show(json_text(&g->j, uri), show));
	for (k = 0; k < size; k++)
		if (name[k] == '%' && size - k > 2 && (byte = json_hex(name + k + 1, 2)) >= 0)
			name[m++] = (char)byte, k += 2;
		else
			name[m++] = name[k];
	snprintf(what, sizeof what, "buffer %lld", i);
	if ((e = beside_read(g->r, what, (Token){ name, (size_t)m }, 0, (size_t)n, &b->own)) != 0)
		return e;
	b->p = b->own;
	g->size += (size_t)n;
	return 0;
}

/* Buffer i, loaded at its first use. */
static int
buffer(Gltf *g, long long i, GltfBuffer **out)
{
	const long long v = gltf_item(g, GLTF_BUFFERS, i);
	const long long n = json_int(&g->j, json_get(&g->j, v, "byteLength"), -1);
	const long long at = json_get(&g->j, v, "uri");
	const Token uri = json_text(&g->j, at);
	GltfBuffer *b;

	if (v < 0)
		return MESH_EFORMAT;
	*out = b = &g->buffer[i];
	if (b->p)
		return 0;
	if (n < 0)
		return mesh_fail(g->r->s->err, MESH_EFORMAT, "buffer %lld has no byteLength", i);
	b->n = (size_t)n;
	if (uri.n > 0)
		return is_data(uri) ? embedded(g, b, i, uri, n) : external(g, b, i, at, n);
	if (i > 0 || !g->bin || (size_t)n > g->nbin)
		return mesh_fail(g->r->s->err, MESH_EFORMAT, "buffer %lld announces %lld bytes, the binary chunk has %zu", i, n,
		    g->nbin);
	b->p = g->bin;
	return 0;
}

/* The type of the components. */
static int
component(Gltf *g, long long i, long long v, GltfArray *a)
{
	static const struct { long long type; int size, kind; double largest; } TYPE[] = {
		{ 5120, 1, 'i', 127 }, { 5121, 1, 'u', 255 }, { 5122, 2, 'i', 32767 }, { 5123, 2, 'u', 65535 },
		{ 5125, 4, 'u', 4294967295. }, { 5126, 4, 'f', 1 }
	};
	const long long type = json_int(&g->j, json_get(&g->j, v, "componentType"), -1);
	const Token normalized = json_text(&g->j, json_get(&g->j, v, "normalized"));
	size_t k;

	for (k = 0; k < sizeof TYPE/sizeof *TYPE; k++)
		if (TYPE[k].type == type) {
			a->size = TYPE[k].size;
			a->kind = TYPE[k].kind;
			a->scale = scan_is(normalized, "true") ? TYPE[k].largest : 1;
			return 0;
		}
	return mesh_fail(g->r->s->err, MESH_EFORMAT, "accessor %lld has components of type %lld, which is not read", i, type);
}

int
gltf_accessor(Gltf *g, long long i, int n, GltfArray *a)
{
	const Json *j = &g->j;
	const long long v = gltf_item(g, GLTF_ACCESSORS, i), view = json_get(j, v, "bufferView");
	const long long count = json_int(j, json_get(j, v, "count"), -1), at = json_int(j, json_get(j, v, "byteOffset"), 0);
	long long w, begin, length, stride;
	const Token type = json_text(j, json_get(j, v, "type"));
	GltfBuffer *b;
	int e;

	if (v < 0 || (e = component(g, i, v, a)) != 0)
		return MESH_EFORMAT;
	if (!scan_is(type, n == 3 ? "VEC3" : "SCALAR"))
		return mesh_fail(g->r->s->err, MESH_EFORMAT, "accessor %lld is not of type %s", i, n == 3 ? "VEC3" : "SCALAR");
	if (view < 0 || json_get(j, v, "sparse") >= 0)
		return mesh_fail(g->r->s->err, MESH_EFORMAT, "accessor %lld is sparse or has no bufferView, which is not read", i);
	if ((w = gltf_item(g, GLTF_VIEWS, json_int(j, view, -1))) < 0)
		return MESH_EFORMAT;
	if ((e = buffer(g, json_int(j, json_get(j, w, "buffer"), -1), &b)) != 0)
		return e;
	begin = json_int(j, json_get(j, w, "byteOffset"), 0);
	length = json_int(j, json_get(j, w, "byteLength"), -1);
	stride = json_int(j, json_get(j, w, "byteStride"), 0);
	stride = stride ? stride : n*a->size;           /* some write 0 for none */
	if (begin < 0 || length < 0 || begin > (long long)b->n || length > (long long)b->n - begin)
		return mesh_fail(g->r->s->err, MESH_EFORMAT, "the bufferView of accessor %lld is beyond the %zu bytes of its "
		    "buffer", i, b->n);
	if (count < 0 || at < 0 || stride < n*a->size || stride > 255 || at > length ||
	    (count > 0 && (length - at < n*a->size || (length - at - n*a->size)/stride < count - 1)))
		return mesh_fail(g->r->s->err, MESH_EFORMAT, "accessor %lld announces %lld items, which are beyond its bufferView", i,
		    count);
	a->p = b->p + begin + at;
	a->stride = (size_t)stride;
	a->count = (size_t)count;
	a->n = n;
	return 0;
}

double
gltf_component(const GltfArray *a, size_t i, int c)
{
	const char *p = a->p + i*a->stride + (size_t)(c*a->size);
	unsigned long long w;
	double x;

	if (a->kind == 'f')
		return scan_float(p, 4, 0);
	w = scan_bytes(p, a->size, 0);
	x = (double)w;
	if (a->kind == 'i' && w >> (8*a->size - 1))
		x -= (double)(1ULL << 8*a->size);
	x /= a->scale;
	return a->kind == 'i' && a->scale > 1 && x < -1 ? -1 : x;
}
