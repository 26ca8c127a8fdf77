/* rewrite.c - copies a mesh file line by line, or record by record, with other coordinates. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "meshfile.h"
#include "meshpriv.h"
#include "rewrite.h"
#include "writepriv.h"

/* A file being copied. */
typedef struct Copy {
	const char   *p, *end;
	const Soup   *s;        /* the mesh of the file */
	const double *xyz;      /* new positions */
	double       *normal;   /* [..][3], not normalized */
	Text          t;
	char         *err;
} Copy;

/* ---- normals --------------------------------------------------------- */

/* Twice the area vector of face f. */
static void
area_vector(const Copy *c, int f, double n[3])
{
	const int *v;
	int count = text_corners(c->s, f, &v), k, a;

	n[0] = n[1] = n[2] = 0;
	for (k = 0; k < count; k++) {
		const double *x = c->xyz + 3*(size_t)v[k], *y = c->xyz + 3*(size_t)v[(k+1)%count];

		for (a = 0; a < 3; a++)
			n[a] += (x[(a+1)%3] - c->xyz[3*(size_t)v[0]+(size_t)(a+1)%3])*(y[(a+2)%3] - x[(a+2)%3])
			    - (x[(a+2)%3] - c->xyz[3*(size_t)v[0]+(size_t)(a+2)%3])*(y[(a+1)%3] - x[(a+1)%3]);
	}
}

static void
unit(double n[3])
{
	double length = sqrt(n[0]*n[0] + n[1]*n[1] + n[2]*n[2]);
	int a;

	for (a = 0; a < 3; a++)
		n[a] = length > 0 ? n[a]/length : a == 2;
}

/* ---- text ------------------------------------------------------------ */

static int
append(Copy *c, const char *p, size_t n)
{
	size_t k;

	for (; n > 0; n -= k, p += k) {
		if (!text_room(&c->t))
			return MESH_ENOMEM;
		k = n < TEXT_MAX ? n : TEXT_MAX;
		memcpy(c->t.p + c->t.n, p, k);
		c->t.n += k;
	}
	return 0;
}

static int
append_number(Copy *c, double x, const char *after)
{
	int digits = 15;
	char s[40];

	do
		snprintf(s, sizeof s, "%.*g", digits, x);
	while (strtod(s, NULL) != x && ++digits <= 17);
	if (append(c, s, strlen(s)))
		return MESH_ENOMEM;
	return append(c, after, strlen(after));
}

/* The end of the line at p, behind its LF if it has one. */
static const char *
line_end(const Copy *c, const char *p)
{
	const char *lf = memchr(p, '\n', (size_t)(c->end - p));

	return lf ? lf + 1 : c->end;
}

static int
is_blank(char c)
{
	return c == ' ' || c == '\t';
}

/* Behind the next word of the line that ends at `end`. */
static const char *
behind_word(const char *p, const char *end)
{
	while (p < end && is_blank(*p))
		p++;
	while (p < end && !is_blank(*p) && *p != '\r' && *p != '\n')
		p++;
	return p;
}

/* Whether the line is a statement of that keyword. */
static int
is_statement(const char *p, const char *end, const char *key)
{
	size_t n = strlen(key);

	return (size_t)(end - p) > n && memcmp(p, key, n) == 0 && is_blank(p[n]);
}

/* ---- OBJ ------------------------------------------------------------- */

/* Adds the area vector of face f, the statement at p, to the normals that its corners use.  vn: normals so far. */
static int
use_normals(Copy *c, const char *p, const char *end, int f, int vn, int all)
{
	double n[3];
	const char *q, *slash;
	long k;
	int a;

	area_vector(c, f, n);
	for (p = behind_word(p, end); (q = behind_word(p, end)) > p; p = q) {
		slash = memchr(p, '/', (size_t)(q - p));
		slash = slash ? memchr(slash + 1, '/', (size_t)(q - slash) - 1) : NULL;
		if (!slash)
			continue;
		k = strtol(slash + 1, NULL, 10);
		k = k < 0 ? vn + k : k - 1;
		if (k < 0 || k >= all)
			return mesh_fail(c->err, MESH_EFORMAT, "face %d has a normal that is not there", f);
		for (a = 0; a < 3; a++)
			c->normal[3*k+a] += n[a];
	}
	return 0;
}

/* Sets the normals. */
static int
obj_normals(Copy *c)
{
	const char *p, *end;
	int all = 0, vn = 0, f = 0, e = 0;

	for (p = c->p; p < c->end; p = end) {
		end = line_end(c, p);
		all += is_statement(p, end, "vn");
	}
	c->normal = calloc((size_t)all + 1, 3*sizeof *c->normal);
	if (!c->normal)
		return MESH_ENOMEM;
	for (p = c->p; p < c->end && !e; p = end) {
		end = line_end(c, p);
		vn += is_statement(p, end, "vn");
		if (is_statement(p, end, "f") && f < c->s->nf)
			e = use_normals(c, p, end, f++, vn, all);
	}
	return e;
}

/* Replaces the first three numbers of the statement. */
static int
obj_numbers(Copy *c, const char *key, const char *p, const char *end, const double x[3])
{
	const char *rest = p;
	int k, e = append(c, key, strlen(key));

	for (k = 0; k < 4; k++)
		rest = behind_word(rest, end);
	for (k = 0; k < 3 && !e; k++)
		e = append_number(c, x[k], k < 2 ? " " : "");
	return e ? e : append(c, rest, (size_t)(end - rest));
}

static int
obj(Copy *c)
{
	const char *p, *end, *q;
	int v = 0, vn = 0, e = 0;

	for (p = c->p; p < c->end; p = end) {
		end = line_end(c, p);
		for (q = end; q > p && (q[-1] == '\n' || q[-1] == '\r'); q--)
			;
		if (q > p && q[-1] == '\\')
			return mesh_fail(c->err, MESH_EFORMAT, "a statement is continued by \\ on the next line");
	}
	if ((e = obj_normals(c)) != 0)
		return e;
	for (p = c->p; p < c->end && !e; p = end) {
		end = line_end(c, p);
		if (is_statement(p, end, "v")) {
			e = obj_numbers(c, "v ", p, end, c->xyz + 3*(size_t)v);
			v++;
		} else if (is_statement(p, end, "vn")) {
			unit(c->normal + 3*(size_t)vn);
			e = obj_numbers(c, "vn ", p, end, c->normal + 3*(size_t)vn);
			vn++;
		} else
			e = append(c, p, (size_t)(end - p));
	}
	return e;
}

/* ---- PLY ------------------------------------------------------------- */

enum { PLY_NUMBERS = 6 };               /* x y z nx ny nz */

/* Where the vertices are in the file. */
typedef struct Layout {
	int       ascii, big;
	long long before;       /* bytes, or in ASCII lines, of elements before the vertices */
	int       size;         /* of a record in bytes */
	int       at[PLY_NUMBERS], kind[PLY_NUMBERS];   /* place in the record, in bytes or words, -1: not there;
	                                                 * size of the number */
} Layout;

static int
type_size(const char *type)
{
	static const struct { const char *name; int size; } known[] = { { "char", 1 }, { "int8", 1 }, { "uchar", 1 },
	    { "uint8", 1 }, { "short", 2 }, { "int16", 2 }, { "ushort", 2 }, { "uint16", 2 }, { "int", 4 }, { "int32", 4 },
	    { "uint", 4 }, { "uint32", 4 }, { "float", 4 }, { "float32", 4 }, { "double", 8 }, { "float64", 8 } };
	size_t i;

	for (i = 0; i < sizeof known/sizeof *known; i++)
		if (strcmp(known[i].name, type) == 0)
			return known[i].size;
	return 0;
}

/* A property of the vertices. */
static int
vertex_property(Copy *c, Layout *l, const char *type, const char *name, int words)
{
	static const char *const known[PLY_NUMBERS] = { "x", "y", "z", "nx", "ny", "nz" };
	int k, real = strcmp(type, "float") == 0 || strcmp(type, "float32") == 0 || type_size(type) == 8;

	if (strcmp(type, "list") == 0)
		return mesh_fail(c->err, MESH_EFORMAT, "the vertices have a list, so their records differ in size");
	for (k = 0; k < PLY_NUMBERS; k++)
		if (strcmp(name, known[k]) == 0) {
			if (!real)
				return mesh_fail(c->err, MESH_EFORMAT, "property %s is of type %s, which holds no fractions", name, type);
			l->at[k] = l->ascii ? words : l->size;
			l->kind[k] = type_size(type);
		}
	l->size += type_size(type);
	return 0;
}

/* Reads the header, and moves c->p behind it. */
static int
ply_layout(Copy *c, Layout *l)
{
	char line[400], type[40], name[80], element[40] = "";
	const char *end;
	long long count = 0, size = 0;
	int words = 0, seen = 0, e, k;
	size_t n;

	*l = (Layout){ .ascii = 0 };
	for (k = 0; k < PLY_NUMBERS; k++)
		l->at[k] = -1;
	for (; c->p < c->end; c->p = end) {
		end = line_end(c, c->p);
		n = (size_t)(end - c->p) < sizeof line ? (size_t)(end - c->p) : sizeof line - 1;
		memcpy(line, c->p, n);
		line[n] = '\0';
		if (sscanf(line, "format %39s", type) == 1) {
			l->ascii = strcmp(type, "ascii") == 0;
			l->big = strcmp(type, "binary_big_endian") == 0;
		} else if (sscanf(line, "element %39s %lld", name, &count) == 2) {
			if (!seen && element[0])
				l->before += size;
			snprintf(element, sizeof element, "%.39s", name);
			seen |= strcmp(element, "vertex") == 0;
			size = l->ascii ? count : 0;
		} else if (sscanf(line, "property %39s %79s", type, name) == 2) {
			if (strcmp(element, "vertex") == 0) {
				if ((e = vertex_property(c, l, type, name, words++)) != 0)
					return e;
			} else if (!seen && !l->ascii) {
				if (strcmp(type, "list") == 0)
					return mesh_fail(c->err, MESH_EFORMAT, "element %s with a list comes before the vertices", element);
				size += count*type_size(type);
			}
		} else if (strncmp(line, "end_header", 10) == 0) {
			c->p = end;
			return 0;
		}
	}
	return mesh_fail(c->err, MESH_EFORMAT, "the header has no end");
}

static void
put_real(char *to, double x, int size, int big)
{
	float y = (float)x;
	uint64_t w = 0;
	uint32_t w4;
	int k;

	if (size == 8)
		memcpy(&w, &x, 8);
	else {
		memcpy(&w4, &y, 4);
		w = w4;
	}
	for (k = 0; k < size; k++)
		to[big ? size - 1 - k : k] = (char)(w >> 8*k & 0xff);
}

static double
number_of(const Copy *c, int i, int k)
{
	return k < 3 ? c->xyz[3*(size_t)i+(size_t)k] : c->normal[3*(size_t)i+(size_t)k-3];
}

static int
ply_binary(Copy *c, const Layout *l)
{
	size_t from;
	int i, k;

	if (l->before > c->end - c->p || append(c, c->p, (size_t)l->before))
		return MESH_ENOMEM;
	c->p += l->before;
	for (i = 0; i < c->s->nv; i++, c->p += l->size) {
		from = c->t.n;
		if (append(c, c->p, (size_t)l->size))
			return MESH_ENOMEM;
		for (k = 0; k < PLY_NUMBERS; k++)
			if (l->at[k] >= 0)
				put_real(c->t.p + from + l->at[k], number_of(c, i, k), l->kind[k], l->big);
	}
	return append(c, c->p, (size_t)(c->end - c->p));
}

static int
ply_line(Copy *c, const Layout *l, int i, const char *p, const char *end)
{
	const char *q;
	int word, k, e = 0;

	for (word = 0; !e && p < end; p = q, word++) {
		q = behind_word(p, end);
		for (k = 0; k < PLY_NUMBERS && l->at[k] != word; k++)
			;
		if (q == p || k == PLY_NUMBERS) {
			q = q == p ? end : q;
			e = append(c, p, (size_t)(q - p));
			continue;
		}
		if (word > 0)
			e = append(c, " ", 1);
		if (!e)
			e = append_number(c, number_of(c, i, k), "");
	}
	return e;
}

static int
ply_text(Copy *c, const Layout *l)
{
	const char *end;
	long long k;
	int i, e = 0;

	for (k = 0; !e && k < l->before; k++, c->p = end) {
		end = line_end(c, c->p);
		e = append(c, c->p, (size_t)(end - c->p));
	}
	for (i = 0; !e && i < c->s->nv; i++, c->p = end) {
		end = line_end(c, c->p);
		e = ply_line(c, l, i, c->p, end);
	}
	return e ? e : append(c, c->p, (size_t)(c->end - c->p));
}

static int
ply(Copy *c)
{
	const char *start = c->p;
	double n[3];
	const int *v;
	int f, k, a, e;
	Layout l;

	c->normal = calloc((size_t)c->s->nv, 3*sizeof *c->normal);
	if (!c->normal)
		return MESH_ENOMEM;
	for (f = 0; f < c->s->nf; f++) {
		area_vector(c, f, n);
		for (k = text_corners(c->s, f, &v) - 1; k >= 0; k--)
			for (a = 0; a < 3; a++)
				c->normal[3*(size_t)v[k]+(size_t)a] += n[a];
	}
	for (k = 0; k < c->s->nv; k++)
		unit(c->normal + 3*(size_t)k);
	if ((e = ply_layout(c, &l)) != 0)
		return e;
	if ((e = append(c, start, (size_t)(c->p - start))) != 0)
		return e;
	return l.ascii ? ply_text(c, &l) : ply_binary(c, &l);
}

int
rewrite(const char *bytes, size_t n, int nv, const double *xyz, char **out, size_t *outn, char err[MESH_ERRLEN])
{
	Soup s;
	Copy c = { bytes, bytes + n, &s, xyz, NULL, { NULL, 0, 0 }, err };
	int is_ply = n > 4 && memcmp(bytes, "ply", 3) == 0, e = meshfile_parse(&s, bytes, n, MESHFILE_MOST);

	if (e) {
		snprintf(err, MESH_ERRLEN, "%s", s.err);
		return e;
	}
	if (n > 1 && (unsigned char)bytes[0] == 0x1f)
		e = mesh_fail(err, MESH_EFORMAT, "the file is gzipped: gunzip it first");
	else if (s.nv != nv)
		e = mesh_fail(err, MESH_EFORMAT, "the file has %d vertices, the mesh with (u,v) has %d", s.nv, nv);
	else
		e = is_ply ? ply(&c) : obj(&c);
	soup_free(&s);
	free(c.normal);
	if (e) {
		if (e == MESH_ENOMEM)
			mesh_fail(err, e, "no memory for %zu bytes", n);
		free(c.t.p);
		return e;
	}
	*out = c.t.p;
	*outn = c.t.n;
	return 0;
}
