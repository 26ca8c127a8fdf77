/* meshwrite.c - a mesh as the bytes of a file. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "meshfile.h"
#include "writepriv.h"

/* x with the fewest of 15, 16 or 17 digits that read back as x. */
static void
number(Text *t, double x, char after)
{
	char *s = t->p + t->n;
	int digits = 15;

	do
		snprintf(s, 32, "%.*g", digits, x);
	while (strtod(s, NULL) != x && ++digits <= 17);
	t->n += strlen(s);
	t->p[t->n++] = after;
}

static void
words(Text *t, const char *s)
{
	size_t n = strlen(s);

	memcpy(t->p + t->n, s, n);
	t->n += n;
}

/* A whole number >= 0. */
static void
whole(Text *t, int i)
{
	char digit[12];
	int n = 0;

	do
		digit[n++] = (char)('0' + i % 10);
	while ((i /= 10) > 0);
	while (n > 0)
		t->p[t->n++] = digit[--n];
}

/* The corners of face f; s->first is NULL where all faces are triangles. */
static int
corners(const Soup *s, int f, const int **v)
{
	*v = s->idx + (s->first ? (size_t)s->first[f] : 3*(size_t)f);
	return s->first ? s->first[f+1] - s->first[f] : 3;
}

/* nv lines of n numbers. */
static int
lines(Text *t, const double *x, int nv, int n, const char *before)
{
	size_t i;
	int c;

	for (i = 0; i < (size_t)nv; i++) {
		if (!text_room(t))
			return MESH_ENOMEM;
		words(t, before);
		for (c = 0; c < n; c++)
			number(t, x[(size_t)n*i + (size_t)c], c < n - 1 ? ' ' : '\n');
	}
	return 0;
}

static int
off(Text *t, const Soup *s)
{
	const int *v;
	int f, i, n;

	if (!text_room(t))
		return MESH_ENOMEM;
	t->n += (size_t)snprintf(t->p + t->n, TEXT_MAX, "OFF\n%d %d 0\n", s->nv, s->nf);
	if (lines(t, s->xyz, s->nv, 3, ""))
		return MESH_ENOMEM;
	for (f = 0; f < s->nf; f++) {
		n = corners(s, f, &v);
		for (i = -1; i < n; i++) {
			if (!text_room(t))
				return MESH_ENOMEM;
			whole(t, i < 0 ? n : v[i]);
			words(t, i < n - 1 ? " " : "\n");
		}
	}
	return 0;
}

static int
objface(Text *t, const Soup *s, int f)
{
	const int *v;
	int i, n = corners(s, f, &v);

	for (i = -1; i < n; i++) {
		if (!text_room(t))
			return MESH_ENOMEM;
		words(t, i < 0 ? "f" : " ");
		if (i >= 0)
			whole(t, v[i] + 1);
		if (i >= 0 && s->uv) {
			words(t, "/");
			whole(t, v[i] + 1);
		}
	}
	words(t, "\n");
	return 0;
}

/* "# lhgrid T 0.91" */
static void
modulus(Text *t, const Soup *s, const char *before)
{
	if (!s->uv || !(s->T > 0))
		return;
	words(t, before);
	words(t, "lhgrid T ");
	number(t, s->T, '\n');
}

static int
obj(Text *t, const Soup *s)
{
	int f, e;

	if (!text_room(t))
		return MESH_ENOMEM;
	modulus(t, s, "# ");
	e = lines(t, s->xyz, s->nv, 3, "v ");
	if (!e && s->uv)
		e = lines(t, s->uv, s->nv, 2, "vt ");
	for (f = 0; !e && f < s->nf; f++)
		e = objface(t, s, f);
	return e;
}

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

/* Bytes of the counts of corners, 1 or 4. */
static int
countsize(const Soup *s)
{
	const int *v;
	int f;

	for (f = 0; f < s->nf; f++)
		if (corners(s, f, &v) > 255)
			return 4;
	return 1;
}

static void
plyhead(Text *t, const Soup *s, int size)
{
	words(t, "ply\nformat binary_little_endian 1.0\n");
	modulus(t, s, "comment ");
	t->n += (size_t)snprintf(t->p + t->n, TEXT_MAX, "element vertex %d\n"
	    "property double x\nproperty double y\nproperty double z\n%s"
	    "element face %d\nproperty list %s int vertex_indices\nend_header\n", s->nv,
	    s->uv ? "property double s\nproperty double t\n" : "", s->nf, size > 1 ? "int" : "uchar");
}

static int
ply(Text *t, const Soup *s)
{
	const int size = countsize(s), *v;
	int f, i, n;

	if (!text_room(t))
		return MESH_ENOMEM;
	plyhead(t, s, size);
	for (i = 0; i < s->nv; i++) {
		if (!text_room(t))
			return MESH_ENOMEM;
		doubles(t, s->xyz + 3*(size_t)i, 3);
		if (s->uv)
			doubles(t, s->uv + 2*(size_t)i, 2);
	}
	for (f = 0; f < s->nf; f++) {
		n = corners(s, f, &v);
		for (i = -1; i < n; i++) {
			if (!text_room(t))
				return MESH_ENOMEM;
			text_bytes(t, (uint64_t)(i < 0 ? n : v[i]), i < 0 ? size : 4);
		}
	}
	return 0;
}

/* Hand over what t holds, or free it. */
static int
finish(Text *t, int e, char **out, size_t *n)
{
	if (e) {
		free(t->p);
		return e;
	}
	*out = t->p;
	*n = t->n;
	return 0;
}

int
meshfile_format_soup(const Soup *s, int kind, char **out, size_t *n)
{
	Text t = { NULL, 0, 0 };
	int e = kind == MESHFILE_OFF ? off(&t, s) : kind == MESHFILE_OBJ ? obj(&t, s) : ply(&t, s);

	return finish(&t, e, out, n);
}

int
meshfile_format(const Mesh *m, int kind, char **out, size_t *n)
{
	const Soup s = { .nv = m->nv, .nf = m->nf, .xyz = m->xyz, .idx = m->tri };
	Text t = { NULL, 0, 0 };

	if (kind != MESHFILE_STL)
		return meshfile_format_soup(&s, kind, out, n);
	return finish(&t, text_stl(&t, m), out, n);
}
