/* vtk.c - legacy VTK files of polygons (DATASET POLYDATA), ASCII and binary, versions 1 to 5.1. */
#include <string.h>

#include "vtkpriv.h"

static const char MAGIC[] = "# vtk DataFile Version";

/* The kinds of cells.  Faces are read from polygons and strips; the others are skipped. */
typedef enum Kind { SKIP, POLYGONS, STRIPS } Kind;

int
vtk_recognise(const MeshStart *m)
{
	return start_has(m, MAGIC, sizeof MAGIC - 1) ? MESHSTART_SURE : MESHSTART_NO;
}

/* Four lines: the version, a title, ASCII or BINARY, the kind of data set. */
static int
header(Vtk *v)
{
	Reader *r = v->r;
	char show[SCAN_SHOW];
	Token t = { "", 0 };

	r->p += sizeof MAGIC - 1;
	scan_word(r, &t);
	v->offsets = t.n > 0 && *t.s >= '5' && *t.s <= '9';
	vtk_nextline(r);
	vtk_nextline(r);
	if (!scan_token(r, &t))
		return mesh_fail(r->s->err, MESH_EFORMAT, "file ends in the header");
	v->binary = scan_is(t, "BINARY");
	if (!v->binary && !scan_is(t, "ASCII"))
		return mesh_fail(r->s->err, MESH_EFORMAT, "line %ld: '%s' is not ASCII or BINARY", r->line, scan_show(t, show));
	return 0;
}

/* Adds corner i to a face of this kind. */
static int
corner(Vtk *v, Kind kind, Strip *strip, const char *what, long long cell, double i)
{
	if (!(i >= -9e15 && i <= 9e15) || i != (double)(long long)i)
		return mesh_fail(v->r->s->err, MESH_EFORMAT, "%s %lld has a corner %g, not a whole number", what, cell, i);
	if (kind == SKIP)
		return 0;
	if (i < 0)
		return mesh_fail(v->r->s->err, MESH_EINDEX, "%s %lld refers to vertex %lld", what, cell, (long long)i);
	return kind == STRIPS ? soup_strip(v->r, strip, (long long)i) : soup_corner(v->r, (long long)i);
}

/* Reserves memory for n cells with `corners` corners in all: for polygons faces and corners, for strips as
 * many triangles as they can have. */
static int
reserve(Vtk *v, Kind kind, long long n, long long corners)
{
	if (kind == POLYGONS)
		return soup_reserve(v->r, 0, (size_t)n, (size_t)corners);
	return kind == STRIPS ? soup_reserve(v->r, 0, (size_t)corners, 3*(size_t)corners) : 0;
}

/* Reads a number of corners, or the index of the first corner of a cell: at least lo, at most hi. */
static int
bound(Vtk *v, Reader *r, const VtkType *type, const char *what, long long i, long long n, long long lo, long long hi,
	long long *at)
{
	double x;
	int e = vtk_value(v, r, type, what, i, n, &x);

	if (e)
		return e;
	if (!(x >= (double)lo && x <= (double)hi) || x != (double)(long long)x)
		return mesh_fail(v->r->s->err, MESH_EFORMAT, "%s %lld of %lld has the size or offset %g, need %lld to %lld", what, i,
		    n, x, lo, hi);
	*at = (long long)x;
	return 0;
}

/* Cells before version 5: "n size", then n times a number of corners and the corners, `size` numbers in all. */
static int
cells(Vtk *v, Kind kind, const char *what)
{
	static const VtkType INT = { "int", 4, 'i' };
	long long n, size, c, i, k = 0, used = 0;
	Strip strip = { 0, 0, 0 };
	double x;
	int e;

	if ((e = vtk_count(v, "a number of cells", &n)) != 0 || (e = vtk_count(v, "a number of values", &size)) != 0 ||
	    (e = vtk_data(v, "values of cells", size, &INT)) != 0 ||
	    (e = soup_check_count(v->r, what, n, (size_t)size)) != 0 ||
	    (e = reserve(v, kind, n, size - n)) != 0)
		return e;
	for (c = 0; c < n; c++) {
		if ((e = bound(v, v->r, &INT, what, c, n, 0, size - used - 1, &k)) != 0)
			return e;
		for (i = 0, strip.turn = 0; i < k; i++)
			if ((e = vtk_value(v, v->r, &INT, what, c, n, &x)) != 0 || (e = corner(v, kind, &strip, what, c, x)) != 0)
				return e;
		used += k + 1;
		if (kind == POLYGONS && (e = soup_face(v->r)) != 0)
			return e;
	}
	if (used != size)
		return mesh_fail(v->r->s->err, MESH_EFORMAT, "%s: %lld values announced, %lld used", what, size, used);
	return 0;
}

/* The line "OFFSETS type" or "CONNECTIVITY type" before n values. */
static int
array(Vtk *v, const char *keyword, long long n, const VtkType **type)
{
	char show[SCAN_SHOW];
	Token t = { "", 0 };
	int e;

	if (!scan_token(v->r, &t) || !scan_is(t, keyword))
		return mesh_fail(v->r->s->err, MESH_EFORMAT, "line %ld: '%s' where %s belongs", v->r->line, scan_show(t, show),
		    keyword);
	if ((e = vtk_type(v, type)) != 0)
		return e;
	return vtk_data(v, keyword, n, *type);
}

/* Cells since version 5: "n size", n offsets of which the first is 0 and the last is size, then the corners.
 * Offsets and corners are read side by side. */
static int
cells5(Vtk *v, Kind kind, const char *what)
{
	const VtkType *otype = NULL, *type = NULL;
	long long n, size, c, i, lo = 0, hi = 0;
	Strip strip = { 0, 0, 0 };
	Reader at;
	double x;
	int e;

	if ((e = vtk_count(v, "a number of offsets", &n)) != 0 || (e = vtk_count(v, "a number of corners", &size)) != 0)
		return e;
	if (n == 0)
		return 0;
	if ((e = array(v, "OFFSETS", n, &otype)) != 0)
		return e;
	at = *v->r;
	for (c = 0; c < n; c++)
		if ((e = vtk_value(v, v->r, otype, what, c, n, &x)) != 0)
			return e;
	if ((e = array(v, "CONNECTIVITY", size, &type)) != 0 || (e = reserve(v, kind, n - 1, size)) != 0 ||
	    (e = bound(v, &at, otype, what, 0, n, 0, 0, &lo)) != 0)
		return e;
	for (c = 1; c < n; c++, lo = hi) {
		if ((e = bound(v, &at, otype, what, c, n, c == n - 1 ? size : lo, size, &hi)) != 0)
			return e;
		for (i = lo, strip.turn = 0; i < hi; i++)
			if ((e = vtk_value(v, v->r, type, what, c - 1, n - 1, &x)) != 0 ||
			    (e = corner(v, kind, &strip, what, c - 1, x)) != 0)
				return e;
		if (kind == POLYGONS && (e = soup_face(v->r)) != 0)
			return e;
	}
	return 0;
}

static int
points(Vtk *v)
{
	const VtkType *type = NULL;
	long long n, i;
	double x[3];
	int e;

	if ((e = vtk_count(v, "a number of points", &n)) != 0 || (e = vtk_type(v, &type)) != 0)
		return e;
	if ((e = soup_check_count(v->r, "points", n, scan_left(v->r)/3)) != 0 ||
	    (e = vtk_data(v, "coordinates", 3*n, type)) != 0 || (e = soup_reserve(v->r, (size_t)n, 0, 0)) != 0)
		return e;
	for (i = 0; i < 3*n; i++) {
		if ((e = vtk_value(v, v->r, type, "vertex", i/3, n, &x[i%3])) != 0)
			return e;
		if (i%3 == 2 && (e = soup_vertex(v->r, x)) != 0)
			return e;
	}
	return 0;
}

/* Reads the section of this keyword.  *known: whether it is one. */
static int
section(Vtk *v, Token t, int *known)
{
	static const struct { const char *name, *what; Kind kind; } CELLS[] = {
		{ "VERTICES", "vertex cell", SKIP }, { "LINES", "line", SKIP }, { "POLYGONS", "face", POLYGONS },
		{ "TRIANGLE_STRIPS", "strip", STRIPS }
	};
	char show[SCAN_SHOW];
	size_t i;

	*known = 1;
	for (i = 0; i < sizeof CELLS/sizeof *CELLS; i++)
		if (scan_is(t, CELLS[i].name))
			return (v->offsets ? cells5 : cells)(v, CELLS[i].kind, CELLS[i].what);
	if (scan_is(t, "POINTS"))
		return points(v);
	if (scan_is(t, "DATASET")) {
		if (scan_word(v->r, &t) && scan_is(t, "POLYDATA"))
			return 0;
		return mesh_fail(v->r->s->err, MESH_EFORMAT, "line %ld: DATASET %s is not read, only POLYDATA", v->r->line,
		    scan_show(t, show));
	}
	if (scan_is(t, "METADATA")) {   /* lines up to an empty one */
		while (vtk_nextline(v->r), scan_word(v->r, &t))
			continue;
		return 0;
	}
	return vtk_attribute(v, t, known);
}

int
vtk_read(Reader *r)
{
	Vtk v = { .r = r };
	char show[SCAN_SHOW];
	int e, known;
	Token t;

	if ((e = header(&v)) != 0)
		return e;
	while (scan_token(r, &t)) {
		if ((e = section(&v, t, &known)) != 0)
			return e;
		if (!known)
			return mesh_fail(r->s->err, MESH_EFORMAT, "%zu bytes before the end: '%s' is not a keyword that is read",
			    scan_left(r) + t.n, scan_show(t, show));
	}
	soup_trim(r);
	return r->s->nv ? 0 : mesh_fail(r->s->err, MESH_EFORMAT, "no POINTS");
}
