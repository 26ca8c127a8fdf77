/* obj.c - Wavefront OBJ: v and f lines. */
#include <string.h>

#include "meshpriv.h"

static int
bad(Reader *r, const char *what, Token t)
{
	char show[SCAN_SHOW];

	return mesh_fail(r->s->err, MESH_EFORMAT, "line %ld: '%s' is not %s",
	    r->line, scan_show(t, show), what);
}

/* The next word of this statement: a backslash at the end of a line joins the next. */
static int
word(Reader *r, Token *t)
{
	while (scan_word(r, t)) {
		if (t->s[t->n-1] != '\\')
			return 1;
		r->p += r->p < r->end && *r->p == '\r';
		if (r->p < r->end && *r->p == '\n')
			r->p++, r->line++;
		if (--t->n > 0)
			return 1;
	}
	return 0;
}

/* x y z, then perhaps w or a colour. */
static int
vertex(Reader *r)
{
	double x[3], rest;
	Token t = { "", 0 };
	int n;

	for (n = 0; word(r, &t); n++)
		if (!scan_number(t, n < 3 ? &x[n] : &rest))
			return bad(r, "a coordinate", t);
	if (n < 3 || n > 8)
		return mesh_fail(r->s->err, MESH_EFORMAT, "line %ld: vertex %d has %d numbers",
		    r->line, r->s->nv, n);
	return soup_vertex(r, x);
}

/* a, a/b, a//c or a/b/c; a counts from 1, or back from -1, the vertex before. */
static int
corner(Reader *r, Token t)
{
	const char *slash = memchr(t.s, '/', t.n);
	Token a = { t.s, slash ? (size_t)(slash - t.s) : t.n };
	long long i;
	size_t k;

	for (k = a.n; k < t.n; k++)
		if (!strchr("/-0123456789", t.s[k]) || !t.s[k])
			return bad(r, "a corner", t);
	if (!scan_int(a, &i))
		return bad(r, "a corner", t);
	if (i == 0)
		return mesh_fail(r->s->err, MESH_EINDEX,
		    "face %d has the index 0, OBJ counts from 1", r->s->nf);
	if (i < -(long long)r->s->nv)
		return mesh_fail(r->s->err, MESH_EINDEX,
		    "face %d reaches back %lld vertices, there are %d", r->s->nf, -i, r->s->nv);
	return soup_corner(r, i > 0 ? i - 1 : i + r->s->nv);
}

static int
face(Reader *r)
{
	Token t;
	int e;

	while (word(r, &t))
		if ((e = corner(r, t)) != 0)
			return e;
	return soup_face(r);
}

int
obj_read(Reader *r)
{
	Token t;
	int e;

	r->hash = 1;
	while (scan_token(r, &t)) {
		e = 0;
		if (t.n == 1 && *t.s == 'v')
			e = vertex(r);
		else if (t.n == 1 && *t.s == 'f')
			e = face(r);
		if (e)
			return e;
		scan_skipline(r);
	}
	if (r->s->nv == 0)
		return mesh_fail(r->s->err, MESH_EFORMAT, "OBJ file without vertices");
	return 0;
}
