/* vtp.c - VTK XML polygons (.vtp): ASCII, base64, appended raw or base64, plain or packed by zlib. */
#include <stdlib.h>
#include <string.h>

#include "xml.h"

/* The arrays of a piece that are read. */
enum { POINTS, POLYS, POLY_ENDS, STRIPS, STRIP_ENDS, ARRAYS, NONE = ARRAYS };

typedef struct Vtp {
	Reader *r;
	Token appended;         /* the data after the _ of AppendedData; n = 0: none */
	int appended_base64;
	int head, big, packing; /* of all arrays */
	XmlArray a[ARRAYS + 1]; /* of the piece */
	long long np, npoly, nstrip;
	int section;            /* the first array of the section: POINTS, POLYS, STRIPS, or NONE */
	int array;              /* the array whose element is open, or NONE */
	int pieces;
} Vtp;

static int
unsupported(Vtp *v, const char *what, const char *value, const char *only)
{
	char show[SCAN_SHOW];

	return mesh_fail(v->r->s->err, MESH_EFORMAT, "%s %s is not read, only %s", what,
	    scan_show((Token){ value, strlen(value) }, show), only);
}

static int
file(Vtp *v, const char **attr)
{
	const char *type = xml_attribute(attr, "type"), *head = xml_attribute(attr, "header_type");
	const char *packed = xml_attribute(attr, "compressor");

	if (strcmp(type, "PolyData") != 0)
		return unsupported(v, "VTK XML type", type, "PolyData");
	if (*packed && strcmp(packed, "vtkZLibDataCompressor") != 0)
		return unsupported(v, "data packed by", packed, "by vtkZLibDataCompressor");
	v->packing = *packed ? XML_BLOCKS : XML_PLAIN;
	v->head = strcmp(head, "UInt64") == 0 ? 8 : 4;
	v->big = strcmp(xml_attribute(attr, "byte_order"), "BigEndian") == 0;
	return 0;
}

/* Which array of the section this is, by its name. */
static int
which(const Vtp *v, const char *name)
{
	if (v->section == POINTS || v->section == NONE)
		return v->section;
	if (strcmp(name, "connectivity") == 0)
		return v->section;
	return strcmp(name, "offsets") == 0 ? v->section + 1 : NONE;
}

static int
data_array(Vtp *v, Xml *x, const char **attr)
{
	static const struct { const char *name; int size, kind; } TYPE[] = {
		{ "Float32", 4, 'f' }, { "Float64", 8, 'f' }, { "Int32", 4, 'i' }, { "Int64", 8, 'i' }, { "UInt32", 4, 'u' },
		{ "UInt64", 8, 'u' }
	};
	const char *format = xml_attribute(attr, "format"), *type = xml_attribute(attr, "type");
	XmlArray *a = &v->a[v->array = which(v, xml_attribute(attr, "Name"))];
	long long offset;
	size_t i;
	int e;

	if (v->array == NONE)
		return 0;
	*a = (XmlArray){ .coding = XML_ASCII, .packing = v->packing, .head = v->head, .big = v->big };
	for (i = 0; i < sizeof TYPE/sizeof *TYPE; i++)
		if (strcmp(type, TYPE[i].name) == 0)
			a->size = TYPE[i].size, a->kind = TYPE[i].kind;
	if (!a->size)
		return unsupported(v, "array of type", type, "Float32 Float64 Int32 Int64 UInt32 UInt64");
	if (strcmp(format, "binary") == 0)
		a->coding = XML_BASE64;
	if (strcmp(format, "appended") != 0)
		return 0;
	if ((e = xml_count(x, attr, "offset", &offset)) != 0)
		return e;
	if ((unsigned long long)offset >= v->appended.n)
		return mesh_fail(v->r->s->err, MESH_EFORMAT, "offset %lld is beyond the %zu bytes of AppendedData", offset,
		    v->appended.n);
	a->coding = v->appended_base64 ? XML_BASE64 : XML_RAW;
	a->text = (Token){ v->appended.s + offset, v->appended.n - (size_t)offset };
	v->array = NONE;                                /* not the text of the element */
	return 0;
}

static int
piece(Vtp *v, Xml *x, const char **attr)
{
	int e;

	memset(v->a, 0, sizeof v->a);
	v->npoly = v->nstrip = 0;
	v->section = v->array = NONE;
	if ((e = xml_count(x, attr, "NumberOfPoints", &v->np)) != 0)
		return e;
	if (*xml_attribute(attr, "NumberOfPolys") && (e = xml_count(x, attr, "NumberOfPolys", &v->npoly)) != 0)
		return e;
	return *xml_attribute(attr, "NumberOfStrips") ? xml_count(x, attr, "NumberOfStrips", &v->nstrip) : 0;
}

static int
start(Xml *x, const char *name, const char **attr)
{
	Vtp *v = x->arg;

	if (v->array != NONE && v->a[v->array].text.n == 0)
		v->a[v->array].text = x->text;          /* information keys follow the data */
	if (strcmp(name, "VTKFile") == 0)
		return file(v, attr);
	if (strcmp(name, "Piece") == 0)
		return piece(v, x, attr);
	if (strcmp(name, "Points") == 0)
		v->section = POINTS;
	else if (strcmp(name, "Polys") == 0)
		v->section = POLYS;
	else if (strcmp(name, "Strips") == 0)
		v->section = STRIPS;
	else if (strcmp(name, "DataArray") == 0)
		return data_array(v, x, attr);
	return 0;
}

static int
points(Vtp *v)
{
	double *f;
	long long i;
	int e;

	if (v->np == 0)
		return 0;
	if (v->np > (1LL << 32))
		return mesh_fail(v->r->s->err, MESH_EFORMAT, "header announces %lld points", v->np);
	if (!(f = xmlarray_numbers(v->r, &v->a[POINTS], "coordinates", 3*v->np, &e)))
		return e;
	e = soup_reserve(v->r, (size_t)v->np, 0, 0);
	for (i = 0; !e && i < v->np; i++)
		e = soup_vertex(v->r, f + 3*i);
	free(f);
	return e;
}

/* A number of an array as a whole number of lo or more, else -1. */
static long long
whole(double x, long long lo)
{
	return x >= (double)lo && x <= 9e15 && x == (double)(long long)x ? (long long)x : -1;
}

/* Adds n faces or strips of the piece, whose vertices begin at `base`. */
static int
add(Vtp *v, int array, long long n, const double *ends, const double *corner, long long base)
{
	const char *what = array == POLYS ? "face" : "strip";
	Strip strip = { 0, 0, 0 };
	long long c, i = 0, end, k;
	int e;

	for (c = 0; c < n; c++) {
		for (end = (long long)ends[c], strip.turn = 0; i < end; i++) {
			k = whole(corner[i], 0);
			if (k < 0 || k >= v->np)
				return mesh_fail(v->r->s->err, MESH_EINDEX, "%s %lld refers to vertex %g, there are %lld", what, c,
				    corner[i], v->np);
			e = array == POLYS ? soup_corner(v->r, base + k) : soup_strip(v->r, &strip, base + k);
			if (e)
				return e;
		}
		if (array == POLYS && (e = soup_face(v->r)) != 0)
			return e;
	}
	return 0;
}

/* The faces of the array, POLYS or STRIPS. */
static int
cells(Vtp *v, int array, long long n, long long base)
{
	double *ends, *corner = NULL;
	long long c, before = 0;
	int e;

	if (n == 0)
		return 0;
	if (!(ends = xmlarray_numbers(v->r, &v->a[array + 1], "offsets", n, &e)))
		return e;
	for (c = 0; !e && c < n; c++)
		if ((before = whole(ends[c], before)) < 0)
			e = mesh_fail(v->r->s->err, MESH_EFORMAT, "offset %lld is %g, less than the one before or not whole", c,
			    ends[c]);
	if (!e && (corner = xmlarray_numbers(v->r, &v->a[array], "corners", before, &e)))
		e = array == POLYS ? soup_reserve(v->r, 0, (size_t)n, (size_t)before) :
		    soup_reserve(v->r, 0, (size_t)before, 3*(size_t)before);
	if (!e)
		e = add(v, array, n, ends, corner, base);
	free(corner);
	free(ends);
	return e;
}

static int
end(Xml *x, const char *name)
{
	Vtp *v = x->arg;
	const long long base = v->r->s->nv;
	int e;

	if (strcmp(name, "DataArray") == 0) {
		if (v->array != NONE && v->a[v->array].text.n == 0)
			v->a[v->array].text = x->text;
		v->array = NONE;
	}
	if (strcmp(name, "Points") == 0 || strcmp(name, "Polys") == 0 || strcmp(name, "Strips") == 0)
		v->section = NONE;
	if (strcmp(name, "Piece") != 0)
		return 0;
	v->pieces++;
	if ((e = points(v)) != 0 || (e = cells(v, POLYS, v->npoly, base)) != 0)
		return e;
	return cells(v, STRIPS, v->nstrip, base);
}

/* Finds the data after <AppendedData encoding="..">_.  They may be no XML.  Returns where the element begins, or
 * the end of the file if there is none. */
static const char *
find_appended(Vtp *v)
{
	static const char TAG[] = "<AppendedData";
	const char *p = v->r->p, *end = v->r->end, *tag, *close, *q;
	const size_t n = sizeof TAG - 1;

	for (; (size_t)(end - p) > n && (p = memchr(p, '<', (size_t)(end - p) - n)); p++)
		if (memcmp(p, TAG, n) == 0)
			break;
	if (!p || (size_t)(end - p) <= n)
		return end;
	tag = p;
	if (!(close = memchr(p, '>', (size_t)(end - p))) || !(q = memchr(close, '_', (size_t)(end - close))))
		return tag;
	v->appended = (Token){ q + 1, (size_t)(end - q) - 1 };
	for (; p + 6 <= close; p++)
		if (memcmp(p, "base64", 6) == 0)
			v->appended_base64 = 1;
	return tag;
}

/* Whether the file ends with the end tag of its root. */
static int
ends_whole(const Reader *r)
{
	static const char TAG[] = "</VTKFile>";
	const char *end = r->end;

	while (end > r->p && strchr(" \t\r\n", end[-1]) && end[-1])
		end--;
	return (size_t)(end - r->p) >= sizeof TAG && memcmp(end - (sizeof TAG - 1), TAG, sizeof TAG - 1) == 0;
}

int
vtp_recognise(const MeshStart *m)
{
	return xml_recognise(m, "<VTKFile");
}

int
vtp_read(Reader *r)
{
	Vtp v = { .r = r, .section = NONE, .array = NONE };
	Xml x = { .r = r, .arg = &v, .start = start, .end = end };
	const char *stop = find_appended(&v);
	int e = xml_read(&x, stop, stop == r->end);

	if (e)
		return e;
	if (stop < r->end && !ends_whole(r))
		return mesh_fail(r->s->err, MESH_EFORMAT, "file ends in AppendedData: no </VTKFile>");
	soup_trim(r);
	return v.pieces ? 0 : mesh_fail(r->s->err, MESH_EFORMAT, "no Piece of PolyData");
}
