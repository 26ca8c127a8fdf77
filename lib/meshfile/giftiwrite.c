/* giftiwrite.c - GIFTI files: surfaces (.surf.gii) and fields (.shape.gii), GZipBase64Binary, little-endian. */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

#include "facts.h"
#include "fieldfile.h"
#include "writepriv.h"

/* An array: intent, type, rows and columns, and its numbers, 4 bytes each. */
typedef struct Array {
	const char *intent, *type;
	int         rows, columns;
	uint32_t   *w;          /* [rows][columns], least significant byte first */
} Array;

static uint32_t
little(const void *number)
{
	uint32_t w;
	unsigned char b[4];
	int k;

	memcpy(&w, number, 4);
	for (k = 0; k < 4; k++)
		b[k] = w >> 8*k & 0xff;
	memcpy(&w, b, 4);
	return w;
}

/* The value of a fact, "" if there is none. */
static void
fact(const Soup *s, const char *wanted, char value[FACT_VALUE])
{
	char key[FACT_KEY];
	const char *facts = s->facts;

	while ((facts = fact_next(facts, key, value)))
		if (strcmp(key, wanted) == 0)
			return;
	value[0] = '\0';
}

static int
metadatum(Text *t, const char *name, const char *value)
{
	if (!text_room(t))
		return MESH_ENOMEM;
	t->n += (size_t)snprintf(t->p + t->n, TEXT_MAX, "<MD><Name>%s</Name><Value>%.*s</Value></MD>\n", name, 200, value);
	return 0;
}

static int
is_number(const char *word)
{
	char *end;

	return isfinite(strtod(word, &end)) && end > word && !*end;
}

/* The centre of the volume, "x y z", as three metadata; nothing if it is no three numbers. */
static int
centre(Text *t, const char *c_ras)
{
	static const char *const key[] = { "VolGeomC_R", "VolGeomC_A", "VolGeomC_S" };
	char word[3][64];
	int c, e = 0;

	if (sscanf(c_ras, "%63s %63s %63s", word[0], word[1], word[2]) != 3 || !is_number(word[0]) ||
	    !is_number(word[1]) || !is_number(word[2]))
		return 0;
	for (c = 0; c < 3 && !e; c++)
		e = metadatum(t, key[c], word[c]);
	return e;
}

static int
begin(Text *t, int arrays)
{
	if (!text_room(t))
		return MESH_ENOMEM;
	t->n += (size_t)snprintf(t->p + t->n, TEXT_MAX, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
	    "<!DOCTYPE GIFTI SYSTEM \"http://www.nitrc.org/frs/download.php/115/gifti.dtd\">\n"
	    "<GIFTI Version=\"1.0\" NumberOfDataArrays=\"%d\">\n<MetaData/>\n", arrays);
	return 0;
}

static int
open_array(Text *t, const Array *a)
{
	if (!text_room(t))
		return MESH_ENOMEM;
	t->n += (size_t)snprintf(t->p + t->n, TEXT_MAX, "<DataArray Intent=\"%s\" DataType=\"%s\" "
	    "ArrayIndexingOrder=\"RowMajorOrder\" Dimensionality=\"%d\" Dim0=\"%d\"", a->intent, a->type,
	    a->columns > 1 ? 2 : 1, a->rows);
	if (a->columns > 1)
		t->n += (size_t)snprintf(t->p + t->n, TEXT_MAX, " Dim1=\"%d\"", a->columns);
	if (!text_room(t))
		return MESH_ENOMEM;
	text_words(t, " Encoding=\"GZipBase64Binary\" Endian=\"LittleEndian\" ExternalFileName=\"\" ExternalFileOffset=\"\">\n");
	return 0;
}

/* The numbers, and the end of the array. */
static int
close_array(Text *t, const Array *a)
{
	const size_t n = (size_t)a->rows*(size_t)a->columns*4;
	uLongf packed = compressBound(n);
	Bytef *bytes = malloc(packed);
	int e;

	if (!bytes || !text_room(t) || compress2(bytes, &packed, (const Bytef *)a->w, n, 6) != Z_OK) {
		free(bytes);
		return MESH_ENOMEM;
	}
	text_words(t, "<Data>");
	e = text_base64(t, bytes, packed);
	free(bytes);
	if (e || !text_room(t))
		return MESH_ENOMEM;
	text_words(t, "</Data>\n</DataArray>\n");
	return 0;
}

static int
end(Text *t)
{
	if (!text_room(t))
		return MESH_ENOMEM;
	text_words(t, "</GIFTI>\n");
	return 0;
}

static int
points(Text *t, const Soup *s)
{
	Array a = { "NIFTI_INTENT_POINTSET", "NIFTI_TYPE_FLOAT32", s->nv, 3, malloc(3*(size_t)s->nv*4) };
	char space[FACT_VALUE], c_ras[FACT_VALUE];
	size_t i;
	float x;
	int e = a.w ? open_array(t, &a) : MESH_ENOMEM;

	for (i = 0; !e && i < 3*(size_t)s->nv; i++) {
		x = (float)s->xyz[i];
		a.w[i] = little(&x);
	}
	fact(s, "space", space);
	fact(s, "c_ras", c_ras);
	if (!e && text_room(t))
		text_words(t, "<MetaData>\n");
	e = e ? e : centre(t, c_ras);
	if (!e && !text_room(t))
		e = MESH_ENOMEM;
	if (!e)
		t->n += (size_t)snprintf(t->p + t->n, TEXT_MAX, "</MetaData>\n<CoordinateSystemTransformMatrix>\n"
		    "<DataSpace><![CDATA[%.80s]]></DataSpace>\n"
		    "<TransformedSpace><![CDATA[NIFTI_XFORM_UNKNOWN]]></TransformedSpace>\n"
		    "<MatrixData>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</MatrixData>\n</CoordinateSystemTransformMatrix>\n",
		    strncmp(space, "NIFTI_XFORM_", 12) == 0 && !strpbrk(space, "<>&]") ? space : "NIFTI_XFORM_UNKNOWN");
	e = e ? e : close_array(t, &a);
	free(a.w);
	return e;
}

static int
triangles(Text *t, const Soup *s)
{
	Array a = { "NIFTI_INTENT_TRIANGLE", "NIFTI_TYPE_INT32", s->nf, 3, malloc(3*(size_t)s->nf*4 + 1) };
	int f, c, e = a.w ? 0 : MESH_ENOMEM;
	const int *v;

	for (f = 0; !e && f < s->nf; f++) {
		if (text_corners(s, f, &v) != 3)
			e = MESH_EFACE;
		for (c = 0; !e && c < 3; c++)
			a.w[3*(size_t)f+(size_t)c] = little(&v[c]);
	}
	if (!e && (e = open_array(t, &a)) == 0)
		e = close_array(t, &a);
	free(a.w);
	return e;
}

int
gifti_write(Text *t, const Soup *s)
{
	size_t i;
	int e;

	for (i = 0; i < 3*(size_t)s->nv; i++)
		if (!(fabs(s->xyz[i]) <= (double)FLT_MAX))
			return MESH_EVALUE;
	if ((e = begin(t, 2)) != 0 || (e = points(t, s)) != 0 || (e = triangles(t, s)) != 0)
		return e;
	return end(t);
}

static int
field(Text *t, const Channel *c, int nv)
{
	Array a = { "NIFTI_INTENT_SHAPE", "NIFTI_TYPE_FLOAT32", nv, 1, malloc((size_t)nv*4 + 1) };
	int i, e = a.w ? open_array(t, &a) : MESH_ENOMEM;
	float x;

	for (i = 0; !e && i < nv; i++) {
		x = (float)c->f[i];
		a.w[i] = little(&x);
	}
	if (!e && text_room(t))
		text_words(t, "<MetaData>\n");
	e = e ? e : metadatum(t, "Name", c->name);
	if (!e && text_room(t))
		text_words(t, "</MetaData>\n");
	e = e ? e : close_array(t, &a);
	free(a.w);
	return e;
}

int
giftifields_write(Text *t, const Channels *c, int nv, int nf)
{
	int k, e = begin(t, c->n);

	(void)nf;
	for (k = 0; !e && k < c->n; k++)
		e = field(t, &c->channel[k], nv);
	return e ? e : end(t);
}
