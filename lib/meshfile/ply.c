/* ply.c - the data of a PLY file. */
#include <stdlib.h>
#include <string.h>

#include "../mesh/channel.h"
#include "plypriv.h"

/* The record being read. */
typedef struct Record {
	Ply *p;
	const PlyElem *e;
	long long i;
	Strip strip;
	double x[PLY_USES];
} Record;

static int
truncated(Record *c)
{
	static const char *const what[] = { "", "vertex", "face", "strip" };
	char show[SCAN_SHOW];

	return soup_truncated(c->p->r, c->e->kind ? what[c->e->kind] : scan_show(c->e->name, show),
	    c->i, c->e->n);
}

/* Reads the next value.  Integers of 32 bits are exact in a double. */
static int
value(Record *c, const PlyType *type, double *x)
{
	Reader *r = c->p->r;
	const int big = c->p->format == PLY_BIG;
	char show[SCAN_SHOW];
	long long w;
	Token t;

	if (c->p->format == PLY_ASCII) {
		if (!scan_token(r, &t))
			return truncated(c);
		if (!scan_number(t, x))
			return mesh_fail(r->s->err, MESH_EFORMAT, "line %ld: '%s' is not a number",
			    r->line, scan_show(t, show));
		return 0;
	}
	if (scan_left(r) < (size_t)type->size)
		return truncated(c);
	if (type->kind == 'f') {
		*x = scan_float(r->p, type->size, big);
	} else {
		w = (long long)scan_bytes(r->p, type->size, big);
		if (type->kind == 'i' && w >> (8*type->size - 1))
			w -= 1LL << 8*type->size;
		*x = (double)w;
	}
	r->p += type->size;
	return 0;
}

static int
check_integer(Record *c, double x, double lo)
{
	char show[SCAN_SHOW];

	if (x >= lo && x <= 1e15 && (double)(long long)x == x)
		return 0;
	return mesh_fail(c->p->r->s->err, MESH_EFORMAT, "%s %lld has %g where a whole number belongs",
	    scan_show(c->e->name, show), c->i, x);
}

static int
list_item(Record *c, const PlyProp *q)
{
	double x;
	int e;

	if ((e = value(c, q->type, &x)) != 0)
		return e;
	if (q->use == PLY_SKIP)
		return 0;
	if ((e = check_integer(c, x, c->e->kind == PLY_STRIP ? -1 : -1e15)) != 0)
		return e;
	return c->e->kind == PLY_STRIP ? soup_strip(c->p->r, &c->strip, (long long)x) : soup_corner(c->p->r, (long long)x);
}

static int
list_property(Record *c, const PlyProp *q)
{
	long long k, n;
	double x;
	int e;

	if ((e = value(c, q->count, &x)) != 0 || (e = check_integer(c, x, 0)) != 0)
		return e;
	for (n = (long long)x, c->strip.turn = 0, k = 0; k < n; k++)
		if ((e = list_item(c, q)) != 0)
			return e;
	return 0;
}

/* x if it can be the number of a vertex, else -1. */
static double
number_or_none(double x)
{
	return x >= 0 && x < 1L << 31 && x == (double)(long)x ? x : -1;
}

static int
record(Record *c)
{
	double x;
	int e, i;

	for (i = c->e->p0; i < c->e->p1; i++) {
		const PlyProp *q = &c->p->prop[i];

		e = q->count ? list_property(c, q) : value(c, q->type, &x);
		if (e)
			return e;
		if (!q->count && q->use != PLY_SKIP)
			c->x[q->use] = x;
		if (q->field)
			q->field[c->i] = x;
	}
	if (c->e->kind == PLY_VERTEX && c->p->uv)
		memcpy(c->p->r->uv + 2*c->i, c->x + c->p->uv, 2 * sizeof *c->x);
	if (c->e->kind == PLY_VERTEX && c->p->offset && (e = offset_append(c->p->r, c->x + PLY_OFFSET)) != 0)
		return e;
	if (c->e->kind == PLY_VERTEX && c->p->source)
		c->p->source[c->i] = number_or_none(c->x[PLY_SOURCE]);
	if (c->e->kind == PLY_FACE && c->p->r->s->filled)
		c->p->r->s->filled[c->i] = c->x[PLY_FILLED] != 0;
	if (c->e->kind == PLY_VERTEX)
		return soup_vertex(c->p->r, c->x);
	return c->e->kind == PLY_FACE ? soup_face(c->p->r) : 0;
}

static int
has_use(const Ply *p, const PlyElem *e, int use)
{
	int i;

	for (i = e->p0; i < e->p1; i++)
		if (p->prop[i].use == use)
			return 1;
	return 0;
}

/* Allocates memory for the numbers of vertices in another file, and for the marks of faces in holes,
 * if the file has them. */
static int
reserve_marks(Ply *p, const PlyElem *e)
{
	Soup *s = p->r->s;

	if (e->kind == PLY_VERTEX && has_use(p, e, PLY_SOURCE) &&
	    !(p->source = channel_add(&s->channels, MESH_SOURCE, 1, (size_t)e->n)))
		return mesh_fail(s->err, MESH_ENOMEM, "no memory for the source of %lld vertices", e->n);
	if (e->kind == PLY_FACE && has_use(p, e, PLY_FILLED) &&
	    !(s->filled = mesh_alloc(s->err, (size_t)e->n, 1)))
		return MESH_ENOMEM;
	return 0;
}

/* Checks that the remaining bytes can contain all records of e, and reserves memory for them.  The
 * number of triangles of strips is not known yet: for strips it reserves memory for as many
 * triangles as the remaining bytes can contain. */
static int
reserve(Ply *p, const PlyElem *e)
{
	static const char *const what[] = { "records", "vertices", "faces", "strips" };
	const size_t least = ply_least(p, e), left = scan_left(p->r) + (p->format == PLY_ASCII);
	size_t item = 2, tri;
	int err, i;

	if ((err = soup_check_count(p->r, what[e->kind], e->n, left / least)) != 0)
		return err;
	if ((err = reserve_marks(p, e)) != 0)
		return err;
	if (e->kind == PLY_VERTEX && p->r->fields && (err = ply_fields(p, e)) != 0)
		return err;
	if (e->kind == PLY_VERTEX && p->uv && (err = uv_start(p->r, (size_t)e->n)) != 0)
		return err;
	if (e->kind == PLY_VERTEX)
		return soup_reserve(p->r, (size_t)e->n, 0, 0);
	if (e->kind == PLY_FACE)
		return soup_reserve(p->r, 0, (size_t)e->n, 0);
	if (e->kind == PLY_OTHER)
		return 0;
	for (i = e->p0; i < e->p1; i++)
		if (p->prop[i].use == PLY_CORNERS && p->format != PLY_ASCII)
			item = (size_t)p->prop[i].type->size;
	tri = left / item;
	return soup_reserve(p->r, 0, tri, 3*tri);
}

int
ply_recognise(const MeshStart *m)
{
	const Token t = m->word;

	return t.s == m->p && t.n == 3 && memcmp(t.s, "ply", 3) == 0 ? MESHSTART_LIKELY : MESHSTART_NO;
}

int
ply_read(Reader *r)
{
	Ply p = { .r = r };
	Record c = { .p = &p };
	int e, i;

	if ((e = ply_header(&p)) != 0)
		return e;
	for (i = 0; i < p.ne; i++) {
		c.e = &p.elem[i];
		if (c.e->p0 == c.e->p1 && c.e->kind == PLY_OTHER)
			continue;               /* records without properties have no bytes */
		if ((e = reserve(&p, c.e)) != 0)
			return e;
		for (c.i = 0; c.i < c.e->n; c.i++)
			if ((e = record(&c)) != 0)
				return e;
		if (c.e->kind == PLY_VERTEX)
			ply_field_types(&p, c.e);
		if (c.e->kind == PLY_STRIP) {   /* its faces are not marked */
			free(r->s->filled);
			r->s->filled = NULL;
		}
		if (c.e->kind == PLY_STRIP)     /* strips use little of the reserved memory */
			soup_trim(r);
	}
	if (p.format == PLY_ASCII)
		while (r->p < r->end && strchr(" \t\r\n\v\f", *r->p) && *r->p)
			r->p++;
	if (r->p < r->end)
		return mesh_fail(r->s->err, MESH_EFORMAT, "%zu bytes follow the last record",
		    scan_left(r));
	return 0;
}
