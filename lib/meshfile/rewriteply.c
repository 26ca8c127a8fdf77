/* rewriteply.c - copies a PLY with other coordinates, record by record. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "rewritepriv.h"

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
		end = rewrite_line(c, c->p);
		n = (size_t)(end - c->p) < sizeof line ? (size_t)(end - c->p) : sizeof line - 1;
		memcpy(line, c->p, n);
		line[n] = '\0';
		if (sscanf(line, "format %39s", type) == 1) {
			l->ascii = strcmp(type, "ascii") == 0;
			l->big = strcmp(type, "binary_big_endian") == 0;
		} else if (sscanf(line, "element %39s %lld", name, &count) == 2) {
			if (!seen && element[0])
				l->before += size;
			if (count < 0 || count > c->end - c->p || l->before > c->end - c->p)
				return rewrite_odd(c);
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

	if (l->before + (long long)c->s->nv*l->size > c->end - c->p)
		return rewrite_odd(c);
	if (rewrite_append(c, c->p, (size_t)l->before))
		return MESH_ENOMEM;
	c->p += l->before;
	for (i = 0; i < c->s->nv; i++, c->p += l->size) {
		from = c->t.n;
		if (rewrite_append(c, c->p, (size_t)l->size))
			return MESH_ENOMEM;
		for (k = 0; k < PLY_NUMBERS; k++)
			if (l->at[k] >= 0)
				put_real(c->t.p + from + l->at[k], number_of(c, i, k), l->kind[k], l->big);
	}
	return rewrite_append(c, c->p, (size_t)(c->end - c->p));
}

static int
ply_line(Copy *c, const Layout *l, int i, const char *p, const char *end)
{
	const char *q;
	int word, k, e = 0;

	for (word = 0; !e && p < end; p = q, word++) {
		q = rewrite_word(p, end);
		for (k = 0; k < PLY_NUMBERS && l->at[k] != word; k++)
			;
		if (q == p || k == PLY_NUMBERS) {
			q = q == p ? end : q;
			e = rewrite_append(c, p, (size_t)(q - p));
			continue;
		}
		if (word > 0)
			e = rewrite_append(c, " ", 1);
		if (!e)
			e = rewrite_number(c, number_of(c, i, k));
	}
	return e;
}

static int
ply_text(Copy *c, const Layout *l)
{
	const char *end;
	long long k;
	int i, e = 0;

	for (k = 0; !e && k < l->before && c->p < c->end; k++, c->p = end) {
		end = rewrite_line(c, c->p);
		e = rewrite_append(c, c->p, (size_t)(end - c->p));
	}
	for (i = 0; !e && i < c->s->nv; i++, c->p = end) {
		end = rewrite_line(c, c->p);
		e = ply_line(c, l, i, c->p, end);
	}
	return e ? e : rewrite_append(c, c->p, (size_t)(c->end - c->p));
}

int
rewrite_ply(Copy *c)
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
		rewrite_area(c, f, n);
		for (k = text_corners(c->s, f, &v) - 1; k >= 0; k--)
			for (a = 0; a < 3; a++)
				c->normal[3*(size_t)v[k]+(size_t)a] += n[a];
	}
	for (k = 0; k < c->s->nv; k++)
		rewrite_unit(c->normal + 3*(size_t)k);
	if ((e = ply_layout(c, &l)) != 0)
		return e;
	if ((e = rewrite_append(c, start, (size_t)(c->p - start))) != 0)
		return e;
	return l.ascii ? ply_text(c, &l) : ply_binary(c, &l);
}
