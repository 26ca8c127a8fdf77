/* glbwrite.c - the two chunks of a .glb file: JSON, and the arrays that it describes. */
#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "glb.h"
#include "writepriv.h"

enum { FLOAT = 5126, UINT = 5125, USHORT = 5123, VERTICES = 34962, INDICES = 34963 };

/* The file in the making: the JSON, and the arrays, whose bytes follow it.  views counts the arrays. */
typedef struct Making {
	const Glb *g;
	Text  json, data, views, accessors;
	int   nviews;
	int   failed;
} Making;

static void
say(Making *m, Text *t, const char *fmt, ...)
{
	va_list ap;

	if (m->failed || !text_room(t)) {
		m->failed = 1;
		return;
	}
	va_start(ap, fmt);
	t->n += (size_t)vsnprintf(t->p + t->n, TEXT_MAX, fmt, ap);
	va_end(ap);
}

static void
put_float(Making *m, float x)
{
	uint32_t w;

	memcpy(&w, &x, 4);
	if (m->failed || !text_room(&m->data)) {
		m->failed = 1;
		return;
	}
	text_bytes(&m->data, w, 4);
}

/* Describes the bytes of the data from `from` on as the next buffer view and accessor. */
static void
describe(Making *m, size_t from, int target, int component, int count, const char *type, const char *more)
{
	const char *comma = m->nviews ? "," : "";

	say(m, &m->views, "%s{\"buffer\":0,\"byteOffset\":%zu,\"byteLength\":%zu", comma, from, m->data.n - from);
	if (target)
		say(m, &m->views, ",\"target\":%d", target);
	say(m, &m->views, "}");
	say(m, &m->accessors, "%s{\"bufferView\":%d,\"componentType\":%d,\"count\":%d,\"type\":\"%s\"%s}", comma, m->nviews,
	    component, count, type, more);
	m->nviews++;
}

/* An array of vectors at the vertices, with its bounds. */
static void
put_vectors(Making *m, const float *x)
{
	size_t from = m->data.n, i;
	float lo[3] = { x[0], x[1], x[2] }, hi[3] = { x[0], x[1], x[2] };
	char bounds[200];
	int c;

	for (i = 0; i < 3*(size_t)m->g->nv; i++) {
		c = (int)(i%3);
		lo[c] = x[i] < lo[c] ? x[i] : lo[c];
		hi[c] = x[i] > hi[c] ? x[i] : hi[c];
		put_float(m, x[i]);
	}
	snprintf(bounds, sizeof bounds, ",\"min\":[%.9g,%.9g,%.9g],\"max\":[%.9g,%.9g,%.9g]", lo[0], lo[1], lo[2], hi[0],
	    hi[1], hi[2]);
	describe(m, from, VERTICES, FLOAT, m->g->nv, "VEC3", bounds);
}

/* Sets n to the unit normals of the vertices: means of those of their faces by area. */
static void
normals(const Glb *g, const float *x, float *n)
{
	double e[3], d[3], length;
	int f, k, c;
	size_t i;

	memset(n, 0, 3*(size_t)g->nv*sizeof *n);
	for (f = 0; f < g->nf; f++) {
		const int *v = g->tri + 3*(size_t)f;
		const float *a = x + 3*(size_t)v[0], *b = x + 3*(size_t)v[1], *o = x + 3*(size_t)v[2];

		for (c = 0; c < 3; c++)
			e[c] = (double)b[c] - a[c], d[c] = (double)o[c] - a[c];
		for (k = 0; k < 3; k++)
			for (c = 0; c < 3; c++)
				n[3*(size_t)v[k]+c] += (float)(e[(c+1)%3]*d[(c+2)%3] - e[(c+2)%3]*d[(c+1)%3]);
	}
	for (i = 0; i < 3*(size_t)g->nv; i += 3) {
		length = sqrt((double)n[i]*n[i] + (double)n[i+1]*n[i+1] + (double)n[i+2]*n[i+2]);
		for (c = 0; c < 3; c++)
			n[i+c] = length > 0 ? (float)(n[i+c]/length) : c == 2;
	}
}

static void
put_triangles(Making *m)
{
	size_t from = m->data.n, i;

	for (i = 0; i < 3*(size_t)m->g->nf && !m->failed; i++) {
		m->failed = !text_room(&m->data);
		if (!m->failed)
			text_bytes(&m->data, (uint64_t)m->g->tri[i], 4);
	}
	describe(m, from, INDICES, UINT, 3*m->g->nf, "SCALAR", "");
}

static void
put_colours(Making *m)
{
	size_t from = m->data.n, i;

	for (i = 0; i < 4*(size_t)m->g->nv && !m->failed; i++) {
		m->failed = !text_room(&m->data);
		if (!m->failed)
			text_bytes(&m->data, m->g->colour[i], 2);
	}
	describe(m, from, VERTICES, USHORT, m->g->nv, "VEC4", ",\"normalized\":true");
}

/* Positions and normals of all frames: those of the first, and the differences of the others from them. */
static void
put_frames(Making *m)
{
	size_t n = 3*(size_t)m->g->nv, i;
	float *first = malloc(n*sizeof *first), *now = malloc(n*sizeof *now), *shift = malloc(n*sizeof *shift);
	int k;

	m->failed |= !first || !now || !shift;
	if (!m->failed) {
		normals(m->g, m->g->xyz[0], first);
		put_vectors(m, m->g->xyz[0]);
		put_vectors(m, first);
	}
	for (k = 1; k < m->g->frames && !m->failed; k++) {
		normals(m->g, m->g->xyz[k], now);
		for (i = 0; i < n; i++) {
			now[i] -= first[i];
			shift[i] = m->g->xyz[k][i] - m->g->xyz[0][i];
		}
		put_vectors(m, shift);
		put_vectors(m, now);
	}
	free(first);
	free(now);
	free(shift);
}

/* Times, and at each the weights of all targets: 1 for that of the frame. */
static void
put_animation(Making *m)
{
	size_t from = m->data.n;
	int frames = m->g->frames, k, l;
	char bounds[80];

	for (k = 0; k < frames; k++)
		put_float(m, (float)(k*m->g->seconds));
	snprintf(bounds, sizeof bounds, ",\"min\":[0],\"max\":[%.9g]", (float)((frames - 1)*m->g->seconds));
	describe(m, from, 0, FLOAT, frames, "SCALAR", bounds);
	from = m->data.n;
	for (k = 0; k < frames; k++)
		for (l = 1; l < frames; l++)
			put_float(m, l == k);
	describe(m, from, 0, FLOAT, frames*(frames - 1), "SCALAR", "");
}

/* The JSON.  The accessors are: triangles, colours if there are any, then positions and normals of each frame,
 * times, weights. */
static void
put_json(Making *m)
{
	int base = m->g->colour ? 2 : 1, frames = m->g->frames, k;
	Text *j = &m->json;

	say(m, j, "{\"asset\":{\"version\":\"2.0\",\"generator\":\"lhgrid\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],"
	    "\"nodes\":[{\"mesh\":0}],\"materials\":[{\"pbrMetallicRoughness\":{\"metallicFactor\":0,"
	    "\"roughnessFactor\":0.8},\"doubleSided\":true}],\"meshes\":[{\"primitives\":[{\"attributes\":{");
	say(m, j, "\"POSITION\":%d,\"NORMAL\":%d", base, base + 1);
	if (m->g->colour)
		say(m, j, ",\"COLOR_0\":1");
	say(m, j, "},\"indices\":0,\"material\":0");
	for (k = 1; k < frames; k++)
		say(m, j, "%s{\"POSITION\":%d,\"NORMAL\":%d}", k == 1 ? ",\"targets\":[" : ",", base + 2*k, base + 2*k + 1);
	say(m, j, "%s}]", frames > 1 ? "]" : "");
	for (k = 1; k < frames; k++)
		say(m, j, "%s0", k == 1 ? ",\"weights\":[" : ",");
	say(m, j, "%s}]", frames > 1 ? "]" : "");
	if (frames > 1)
		say(m, j, ",\"animations\":[{\"channels\":[{\"sampler\":0,\"target\":{\"node\":0,\"path\":\"weights\"}}],"
		    "\"samplers\":[{\"input\":%d,\"output\":%d,\"interpolation\":\"LINEAR\"}]}]", base + 2*frames,
		    base + 2*frames + 1);
	say(m, j, ",\"buffers\":[{\"byteLength\":%zu}],\"bufferViews\":[", m->data.n);
}

static void
append(Making *m, Text *to, const Text *from)
{
	size_t i;

	for (i = 0; i < from->n && !m->failed; i++) {
		m->failed = !text_room(to);
		if (!m->failed)
			to->p[to->n++] = from->p[i];
	}
}

/* Puts header and chunks together in t. */
static void
assemble(Making *m, Text *t)
{
	while (!m->failed && m->json.n % 4)
		say(m, &m->json, " ");
	while (!m->failed && m->data.n % 4)
		put_float(m, 0);
	if (m->failed || !text_room(t)) {
		m->failed = 1;
		return;
	}
	text_words(t, "glTF");
	text_bytes(t, 2, 4);
	text_bytes(t, 12 + 8 + m->json.n + 8 + m->data.n, 4);
	text_bytes(t, m->json.n, 4);
	text_words(t, "JSON");
	append(m, t, &m->json);
	if (m->failed || !text_room(t)) {
		m->failed = 1;
		return;
	}
	text_bytes(t, m->data.n, 4);
	text_bytes(t, 0x004e4942, 4);           /* "BIN" and a zero */
	append(m, t, &m->data);
}

static int
fits(const Glb *g)
{
	double bytes = 12.0*g->nf + 8.0*g->nv + 24.0*g->nv*g->frames + 4.0*g->frames*g->frames + 65536 + 700.0*g->frames;

	return bytes < 4294967296.0;
}

int
glb_write(const Glb *g, char **bytes, size_t *n)
{
	Making m = { .g = g };
	Text t = { NULL, 0, 0 };
	size_t i;
	int k;

	for (k = 0; k < g->frames; k++)
		for (i = 0; i < 3*(size_t)g->nv; i++)
			if (!isfinite(g->xyz[k][i]))
				return GLB_EVALUE;
	if (!fits(g))
		return GLB_ELARGE;
	put_triangles(&m);
	if (g->colour)
		put_colours(&m);
	put_frames(&m);
	if (g->frames > 1)
		put_animation(&m);
	put_json(&m);
	append(&m, &m.json, &m.views);
	say(&m, &m.json, "],\"accessors\":[");
	append(&m, &m.json, &m.accessors);
	say(&m, &m.json, "]}");
	assemble(&m, &t);
	free(m.json.p);
	free(m.data.p);
	free(m.views.p);
	free(m.accessors.p);
	if (m.failed) {
		free(t.p);
		return GLB_ENOMEM;
	}
	*bytes = t.p;
	*n = t.n;
	return 0;
}
