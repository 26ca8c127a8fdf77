/* vtpwrite.c - VTK XML PolyData (.vtp): base64, little-endian, with the fields as point data. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fieldfile.h"
#include "writepriv.h"

/* Numbers of 8 bytes, that grow in memory before they are written with their size in front. */
typedef struct Array {
	unsigned char *b;
	size_t         n;
} Array;

static int
array_init(Array *a, size_t numbers)
{
	a->n = 8;
	a->b = malloc(8*numbers + 8);
	return a->b ? 0 : MESH_ENOMEM;
}

static void
append(Array *a, uint64_t w)
{
	int k;

	for (k = 0; k < 8; k++)
		a->b[a->n++] = w >> 8*k & 0xff;
}

static void
append_double(Array *a, double x)
{
	uint64_t w;

	memcpy(&w, &x, 8);
	append(a, w);
}

/* Appends a name, with _ in place of what an attribute cannot hold. */
static void
name_attribute(Text *t, const char *name)
{
	for (; *name; name++)
		t->p[t->n++] = strchr("<>&\"", *name) ? '_' : *name;
}

/* Writes the element and frees the array. */
static int
element(Text *t, Array *a, const char *type, const char *name, int columns)
{
	size_t bytes = a->n - 8;
	int e = MESH_ENOMEM;

	a->n = 0;
	append(a, bytes);
	if (text_room(t)) {
		t->n += (size_t)snprintf(t->p + t->n, TEXT_MAX, "<DataArray type=\"%s\" Name=\"", type);
		name_attribute(t, name);
		t->n += (size_t)snprintf(t->p + t->n, TEXT_MAX/2, "\" NumberOfComponents=\"%d\" format=\"binary\">\n", columns);
		e = text_base64(t, a->b, bytes + 8);
	}
	free(a->b);
	if (e || !text_room(t))
		return MESH_ENOMEM;
	text_words(t, "\n</DataArray>\n");
	return 0;
}

static int
doubles(Text *t, const char *name, const double *x, int nv, int columns)
{
	size_t i, n = (size_t)nv*(size_t)columns;
	Array a;

	if (array_init(&a, n))
		return MESH_ENOMEM;
	for (i = 0; i < n; i++)
		append_double(&a, x[i]);
	return element(t, &a, "Float64", name, columns);
}

/* The corners of all faces, or where each face ends among them. */
static int
faces(Text *t, const Soup *s, int ends)
{
	size_t n = 0;
	const int *v;
	int f, k, count;
	Array a;

	for (f = 0; f < s->nf; f++)
		n += ends ? 1 : (size_t)text_corners(s, f, &v);
	if (array_init(&a, n))
		return MESH_ENOMEM;
	for (n = 0, f = 0; f < s->nf; f++) {
		count = text_corners(s, f, &v);
		n += (size_t)count;
		if (ends)
			append(&a, n);
		for (k = 0; k < count && !ends; k++)
			append(&a, (uint64_t)v[k]);
	}
	return element(t, &a, "Int64", ends ? "offsets" : "connectivity", 1);
}

static int
words(Text *t, const char *s)
{
	if (!text_room(t))
		return MESH_ENOMEM;
	text_words(t, s);
	return 0;
}

int
vtp_write(Text *t, const Soup *s)
{
	const Channels *c = &s->channels;
	int k, e;

	if (!text_room(t))
		return MESH_ENOMEM;
	t->n += (size_t)snprintf(t->p + t->n, TEXT_MAX, "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
	    "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PolyData>\n"
	    "<Piece NumberOfPoints=\"%d\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"%d\">\n"
	    "<PointData>\n", s->nv, s->nf);
	for (e = 0, k = 0; !e && k < c->n; k++)
		e = doubles(t, c->channel[k].name, c->channel[k].f, s->nv, c->channel[k].n);
	if (e || (e = words(t, "</PointData>\n<Points>\n")) != 0 || (e = doubles(t, "Points", s->xyz, s->nv, 3)) != 0 ||
	    (e = words(t, "</Points>\n<Polys>\n")) != 0 || (e = faces(t, s, 0)) != 0 || (e = faces(t, s, 1)) != 0)
		return e;
	return words(t, "</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n");
}
