/* vtkdata.c - values and attributes of legacy VTK files. */
#include <string.h>

#include "vtkpriv.h"

static const VtkType TYPE[] = {
	{ "float", 4, 'f' }, { "double", 8, 'f' }, { "int", 4, 'i' }, { "unsigned_int", 4, 'u' },
	{ "vtktypeint64", 8, 'i' }, { "vtktypeint32", 4, 'i' }, { "vtkIdType", 4, 'i' },
	{ "long", 8, 'i' }, { "unsigned_long", 8, 'u' }, { "vtktypeuint64", 8, 'u' }, { "vtktypeuint32", 4, 'u' },
	{ "char", 1, 'i' }, { "signed_char", 1, 'i' }, { "unsigned_char", 1, 'u' }, { "short", 2, 'i' },
	{ "unsigned_short", 2, 'u' }
};

void
vtk_nextline(Reader *r)
{
	scan_skipline(r);
	r->p += r->end - r->p > 1 && r->p[0] == '\r' && r->p[1] == '\n';
	if (r->p < r->end)
		r->p++, r->line++;
}

static int
bad(Vtk *v, const char *need, Token t)
{
	char show[SCAN_SHOW];

	return mesh_fail(v->r->s->err, MESH_EFORMAT, "line %ld: '%s' is not %s", v->r->line, scan_show(t, show), need);
}

int
vtk_count(Vtk *v, const char *what, long long *n)
{
	Token t = { "", 0 };

	if (!scan_word(v->r, &t) || !scan_int(t, n) || *n < 0)
		return bad(v, what, t);
	return 0;
}

int
vtk_type(Vtk *v, const VtkType **type)
{
	Token t = { "", 0 };
	size_t i;

	scan_word(v->r, &t);
	for (i = 0; i < sizeof TYPE/sizeof *TYPE; i++)
		if (scan_is(t, TYPE[i].name)) {
			*type = &TYPE[i];
			return 0;
		}
	return bad(v, "a type of numbers that is read", t);
}

int
vtk_data(Vtk *v, const char *what, long long n, const VtkType *type)
{
	Reader *r = v->r;

	if (v->binary)
		vtk_nextline(r);
	return soup_check_count(r, what, n, v->binary ? scan_left(r)/(size_t)type->size : (scan_left(r) + 1)/2);
}

int
vtk_value(const Vtk *v, Reader *r, const VtkType *type, const char *what, long long i, long long n, double *x)
{
	unsigned long long w;

	if (!v->binary)
		return record_number(r, what, i, n, x);
	if (scan_left(r) < (size_t)type->size)
		return soup_truncated(r, what, i, n);
	if (type->kind == 'f') {
		*x = scan_float(r->p, type->size, 1);
	} else {
		w = scan_bytes(r->p, type->size, 1);
		if (type->kind == 'i' && type->size < 8 && w >> (8*type->size - 1))
			*x = (double)w - (double)(1ULL << 8*type->size);
		else
			*x = type->kind == 'i' ? (double)(long long)w : (double)w;
	}
	r->p += type->size;
	return 0;
}

int
vtk_skip(Vtk *v, const VtkType *type, const char *what, long long n)
{
	long long i;
	double x;
	int e;

	if ((e = vtk_data(v, what, n, type)) != 0)
		return e;
	if (v->binary)
		v->r->p += n*type->size;
	for (i = 0; !v->binary && i < n; i++)
		if ((e = record_number(v->r, what, i, n, &x)) != 0)
			return e;
	return 0;
}

/* n times k, or more than any file has if that is too large. */
static long long
times(long long n, long long k)
{
	return k > 0 && n > (1LL << 60)/k ? 1LL << 60 : n*k;
}

/* "SCALARS name type [components]", then "LOOKUP_TABLE name" and the values. */
static int
scalars(Vtk *v)
{
	const VtkType *type = NULL;
	long long k = 1;
	Token t;
	int e;

	scan_word(v->r, &t);
	if ((e = vtk_type(v, &type)) != 0)
		return e;
	if (scan_word(v->r, &t) && (!scan_int(t, &k) || k < 1))
		return bad(v, "a number of components", t);
	if (!scan_token(v->r, &t) || !scan_is(t, "LOOKUP_TABLE"))
		return bad(v, "LOOKUP_TABLE", t);
	scan_word(v->r, &t);
	return vtk_skip(v, type, "scalars", times(v->tuples, k));
}

/* "FIELD name k", then k times "name components tuples type" and the values. */
static int
field(Vtk *v)
{
	const VtkType *type = NULL;
	long long i, k, c, n;
	Token t;
	int e;

	scan_word(v->r, &t);
	if ((e = vtk_count(v, "a number of arrays", &k)) != 0)
		return e;
	for (i = 0; i < k; i++) {
		if (!scan_token(v->r, &t))
			return soup_truncated(v->r, "array of a field", i, k);
		if (scan_is(t, "METADATA")) {
			while (vtk_nextline(v->r), scan_word(v->r, &t))
				continue;
			i--;
			continue;
		}
		if ((e = vtk_count(v, "a number of components", &c)) != 0 ||
		    (e = vtk_count(v, "a number of tuples", &n)) != 0 || (e = vtk_type(v, &type)) != 0 ||
		    (e = vtk_skip(v, type, "values of a field", times(c, n))) != 0)
			return e;
	}
	return 0;
}

/* "COLOR_SCALARS name k": bytes in binary files.  "LOOKUP_TABLE name n": n rgba. */
static int
colours(Vtk *v, int table)
{
	static const VtkType byte = { "unsigned_char", 1, 'u' };
	long long k;
	Token t;
	int e;

	scan_word(v->r, &t);
	if ((e = vtk_count(v, "a number of colours", &k)) != 0)
		return e;
	return vtk_skip(v, &byte, "colours", table ? times(4, k) : times(v->tuples, k));
}

int
vtk_attribute(Vtk *v, Token keyword, int *known)
{
	static const struct { const char *name; int n; } PLAIN[] = {
		{ "VECTORS", 3 }, { "NORMALS", 3 }, { "TENSORS", 9 }, { "TENSORS6", 6 }, { "GLOBAL_IDS", 1 },
		{ "PEDIGREE_IDS", 1 }, { "TEXTURE_COORDINATES", 0 }
	};
	const VtkType *type = NULL;
	long long n;
	size_t i;
	Token t;
	int e;

	*known = 1;
	if (scan_is(keyword, "POINT_DATA") || scan_is(keyword, "CELL_DATA"))
		return vtk_count(v, "a number of points or cells", &v->tuples);
	if (scan_is(keyword, "SCALARS"))
		return scalars(v);
	if (scan_is(keyword, "FIELD"))
		return field(v);
	if (scan_is(keyword, "COLOR_SCALARS") || scan_is(keyword, "LOOKUP_TABLE"))
		return colours(v, scan_is(keyword, "LOOKUP_TABLE"));
	for (i = 0; i < sizeof PLAIN/sizeof *PLAIN; i++)
		if (scan_is(keyword, PLAIN[i].name)) {
			scan_word(v->r, &t);
			n = PLAIN[i].n;
			if (n == 0 && (e = vtk_count(v, "a number of dimensions", &n)) != 0)
				return e;
			if ((e = vtk_type(v, &type)) != 0)
				return e;
			return vtk_skip(v, type, "values of an attribute", times(v->tuples, n));
		}
	*known = 0;
	return 0;
}
