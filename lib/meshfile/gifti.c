/* gifti.c - GIFTI surfaces (.surf.gii): an array of points and one of triangles.  The coordinate transforms of the
 * file are not applied; the space of the coordinates, DataSpace, is kept as a fact. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "facts.h"
#include "xml.h"

/* Where the reader is. */
typedef struct Gifti {
	Reader *r;
	XmlArray a;             /* the DataArray being read */
	long long dim[2];
	int column;             /* its numbers are stored by columns */
	enum { OUTSIDE, OTHER, POINTS, TRIANGLES } intent;
	long long announced, arrays;
	int points, triangles;  /* how many of each were read */
	Token name;             /* of the last metadatum */
	Token centre[3];        /* VolGeomC_R, _A, _S */
	Token space;
} Gifti;

/* The value of the attribute is one of the names; sets *i to its number.  Returns 0 or MESH_EFORMAT. */
static int
choice(Gifti *g, const char **attr, const char *key, const char *const *names, int n, int *i)
{
	const char *value = xml_attribute(attr, key);
	const Token t = { value, strlen(value) };
	char show[SCAN_SHOW];

	for (*i = 0; *i < n; ++*i)
		if (strcmp(names[*i], value) == 0)
			return 0;
	return mesh_fail(g->r->s->err, MESH_EFORMAT, "array %lld: %s=\"%s\" is not read", g->arrays, key, scan_show(t, show));
}

static int
data_array(Gifti *g, Xml *x, const char **attr)
{
	static const char *const type[] = { "NIFTI_TYPE_FLOAT32", "NIFTI_TYPE_INT32", "NIFTI_TYPE_FLOAT64",
	    "NIFTI_TYPE_INT64", "NIFTI_TYPE_UINT32" };
	static const char *const order[] = { "RowMajorOrder", "ColumnMajorOrder" };
	static const char *const endian[] = { "LittleEndian", "BigEndian" };
	static const char *const encoding[] = { "ASCII", "Base64Binary", "GZipBase64Binary", "ExternalFileBinary" };
	const char *intent = xml_attribute(attr, "Intent");
	int e, t, coding;

	if (g->intent != OUTSIDE)
		return mesh_fail(g->r->s->err, MESH_EFORMAT, "array %lld has another in it", g->arrays);
	g->intent = strcmp(intent, "NIFTI_INTENT_POINTSET") == 0 ? POINTS :
	    strcmp(intent, "NIFTI_INTENT_TRIANGLE") == 0 ? TRIANGLES : OTHER;
	if (g->intent == OTHER)
		return 0;
	if ((e = choice(g, attr, "DataType", type, 5, &t)) != 0 ||
	    (e = choice(g, attr, "ArrayIndexingOrder", order, 2, &g->column)) != 0 ||
	    (e = choice(g, attr, "Endian", endian, 2, &g->a.big)) != 0 ||
	    (e = choice(g, attr, "Encoding", encoding, 4, &coding)) != 0 ||
	    (e = xml_count(x, attr, "Dim0", &g->dim[0])) != 0 || (e = xml_count(x, attr, "Dim1", &g->dim[1])) != 0)
		return e;
	if (g->dim[0] > (1LL << 32))
		return mesh_fail(g->r->s->err, MESH_EFORMAT, "array %lld announces %lld rows", g->arrays, g->dim[0]);
	if (g->dim[1] != 3)
		return mesh_fail(g->r->s->err, MESH_EFORMAT, "array %lld has %lld numbers for each %s, not 3", g->arrays,
		    g->dim[1], g->intent == POINTS ? "point" : "triangle");
	g->a.size = t == 2 || t == 3 ? 8 : 4;
	g->a.kind = t == 0 || t == 2 ? 'f' : t == 4 ? 'u' : 'i';
	g->a.coding = coding ? XML_BASE64 : XML_ASCII;
	g->a.packing = coding == 2 ? XML_ZLIB : XML_PLAIN;
	g->a.text = (Token){ NULL, 0 };
	return coding == 3 ? xmlarray_external(x, attr, g->arrays, 3*g->dim[0], &g->a) : 0;
}

static int
start(Xml *x, const char *name, const char **attr)
{
	Gifti *g = x->arg;

	if (strcmp(name, "GIFTI") == 0)
		return xml_count(x, attr, "NumberOfDataArrays", &g->announced);
	return strcmp(name, "DataArray") == 0 ? data_array(g, x, attr) : 0;
}

static int
take_points(Gifti *g, const double *f)
{
	const long long n = g->dim[0];
	long long i;
	double x[3];
	int c, e;

	if ((e = soup_reserve(g->r, (size_t)n, 0, 0)) != 0)
		return e;
	for (i = 0; i < n; i++) {
		for (c = 0; c < 3; c++)
			x[c] = g->column ? f[c*n + i] : f[3*i + c];
		if ((e = soup_vertex(g->r, x)) != 0)
			return e;
	}
	return 0;
}

static int
take_triangles(Gifti *g, const double *f)
{
	const long long n = g->dim[0];
	long long i;
	int c, e;

	if ((e = soup_reserve(g->r, 0, (size_t)n, 3*(size_t)n)) != 0)
		return e;
	for (i = 0; i < n; i++) {
		for (c = 0; c < 3; c++) {
			const double v = g->column ? f[c*n + i] : f[3*i + c];

			if (!(v >= -9e15 && v <= 9e15) || v != (double)(long long)v)
				return mesh_fail(g->r->s->err, MESH_EFORMAT, "face %lld has a corner %g, not a whole number", i, v);
			if ((e = soup_corner(g->r, (long long)v)) != 0)
				return e;
		}
		if ((e = soup_face(g->r)) != 0)
			return e;
	}
	return 0;
}

/* At the end of a DataArray. */
static int
take(Gifti *g)
{
	const int points = g->intent == POINTS;
	const char *what = points ? "coordinates" : "corners";
	int *read = points ? &g->points : &g->triangles, e;
	double *f;

	if ((*read)++)
		return mesh_fail(g->r->s->err, MESH_EFORMAT, "more than one array of %s", points ? "points" : "triangles");
	if (!(f = xmlarray_numbers(g->r, &g->a, what, 3*g->dim[0], &e)))
		return e;
	free(g->a.own);
	g->a.own = NULL;
	g->a.text = (Token){ NULL, 0 };
	e = points ? take_points(g, f) : take_triangles(g, f);
	free(f);
	return e;
}

/* A metadatum. */
static void
value(Gifti *g, Token t)
{
	static const char *const key[] = { "VolGeomC_R", "VolGeomC_A", "VolGeomC_S" };
	int c;

	for (c = 0; c < 3; c++)
		if (g->name.n == 10 && memcmp(g->name.s, key[c], 10) == 0)
			g->centre[c] = t;
}

static int
end(Xml *x, const char *name)
{
	Gifti *g = x->arg;
	int e = 0;

	if (strcmp(name, "Data") == 0 && !g->a.own)
		g->a.text = x->text;
	else if (strcmp(name, "Name") == 0)
		g->name = xml_plain(x->text);
	else if (strcmp(name, "Value") == 0)
		value(g, xml_plain(x->text));
	else if (strcmp(name, "DataSpace") == 0 && g->intent == POINTS)
		g->space = xml_plain(x->text);
	else if (strcmp(name, "DataArray") == 0) {
		if (g->intent != OTHER)
			e = take(g);
		g->intent = OUTSIDE;
		g->arrays++;
	}
	return e;
}

static int
facts(Gifti *g)
{
	enum { LONGEST = 60 };
	char c_ras[3*(LONGEST + 1)];
	size_t k, n = 0;
	int c, e;

	if ((e = fact_add(g->r, "source", (Token){ "GIFTI", 5 })) != 0 ||
	    (e = fact_add(g->r, "unit", (Token){ "mm", 2 })) != 0 ||
	    (e = fact_add(g->r, "space", g->space)) != 0)
		return e;
	if (!g->centre[0].n || !g->centre[1].n || !g->centre[2].n)
		return 0;
	for (c = 0; c < 3; c++) {
		k = g->centre[c].n < LONGEST ? g->centre[c].n : LONGEST;
		memcpy(c_ras + n, g->centre[c].s, k);
		n += k;
		c_ras[n++] = ' ';
	}
	return fact_add(g->r, "c_ras", (Token){ c_ras, n });
}

int
gifti_recognise(const MeshStart *m)
{
	return xml_recognise(m, "<GIFTI");
}

int
gifti_read(Reader *r)
{
	Gifti g = { .r = r, .intent = OUTSIDE, .announced = -1 };
	Xml x = { .r = r, .arg = &g, .start = start, .end = end };
	int e = xml_read(&x, r->end, 1);

	free(g.a.own);
	if (e)
		return e;
	if (g.arrays != g.announced)
		return mesh_fail(r->s->err, MESH_EFORMAT, "NumberOfDataArrays is %lld, the file has %lld", g.announced, g.arrays);
	if (!g.points || !g.triangles)
		return mesh_fail(r->s->err, MESH_EFORMAT, "no surface: no array of %s", g.points ? "triangles" : "points");
	return facts(&g);
}
