/* obj.c - Wavefront OBJ: v and f lines, and vt lines if (u,v) is to be read. */
#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "../base/chart.h"
#include "../base/sheet.h"
#include "meshpriv.h"

/* vt[k] is (u,v) number k of the file; of[c] is the number of the (u,v) of corner c, or -1. */
typedef struct Obj {
	Reader *r;
	double (*vt)[2];
	int    *of;
	int     nt;
	size_t  capt, capo;
} Obj;

static int
bad(Reader *r, const char *what, Token t)
{
	char show[SCAN_SHOW];

	return mesh_fail(r->s->err, MESH_EFORMAT, "line %ld: '%s' is not %s",
	    r->line, scan_show(t, show), what);
}

/* The next word of this statement.  A backslash at the end of a line continues the statement on the
 * next line. */
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

/* Reads a vertex: x y z, optionally followed by w or a colour, which are ignored. */
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

/* Enlarges the array a, by doubling, to have room for item n.  Returns the array, or NULL if memory
 * runs out; a is then unchanged. */
static void *
room(Obj *o, void *a, size_t *cap, size_t n, size_t size)
{
	void *b;

	if (n < *cap)
		return a;
	b = n <= SIZE_MAX / 4 / size ? realloc(a, 2*(n + 8) * size) : NULL;
	if (b)
		*cap = 2*(n + 8);
	else
		mesh_fail(o->r->s->err, MESH_ENOMEM, "no memory for %zu x %zu bytes", 2*(n + 8), size);
	return b;
}

/* Reads a texture coordinate: u v, optionally followed by w, which is ignored. */
static int
texture(Obj *o)
{
	Reader *r = o->r;
	double x[2], rest;
	Token t = { "", 0 };
	void *a;
	int n;

	for (n = 0; word(r, &t); n++)
		if (!scan_number(t, n < 2 ? &x[n] : &rest))
			return bad(r, "a coordinate", t);
	if (n < 2 || n > 3 || o->nt == INT_MAX)
		return mesh_fail(r->s->err, MESH_EFORMAT, "line %ld: vt %d has %d numbers",
		    r->line, o->nt, n);
	if (!isfinite(x[0]) || !isfinite(x[1]))
		return mesh_fail(r->s->err, MESH_EVALUE, "line %ld: vt %d is not finite", r->line, o->nt);
	if (!(a = room(o, o->vt, &o->capt, (size_t)o->nt, sizeof *o->vt)))
		return MESH_ENOMEM;
	o->vt = a;
	memcpy(o->vt[o->nt++], x, sizeof x);
	return 0;
}

/* Converts the OBJ index a to *i, counted from 0.  In the file a counts from 1, or is negative and
 * counts back from the n items read so far.  A positive index may refer to an item that comes
 * later. */
static int
index_from_0(Reader *r, Token a, int n, const char *things, long long *i)
{
	if (!scan_int(a, i))
		return bad(r, "a corner", a);
	if (*i == 0)
		return mesh_fail(r->s->err, MESH_EINDEX,
		    "face %d has the index 0, OBJ counts from 1", r->s->nf);
	if (*i < -(long long)n)
		return mesh_fail(r->s->err, MESH_EINDEX,
		    "face %d refers back by %lld %s, there are %d", r->s->nf, -*i, things, n);
	*i += *i > 0 ? -1 : n;
	return 0;
}

/* Stores in o->of the index b, counted from 0, of the corner a/b or a/b/c that is being read, or -1
 * if the corner has no b.  slash points to the first slash of the corner, or is NULL if there is
 * none; end points behind the corner. */
static int
cornertexture(Obj *o, const char *slash, const char *end)
{
	Token b = { "", 0 };
	long long k = -1;
	void *a;
	int e;

	if (slash)
		for (b.s = slash + 1; b.s + b.n < end && b.s[b.n] != '/'; b.n++)
			continue;
	if (b.n > 0 && (e = index_from_0(o->r, b, o->nt, "vt lines", &k)) != 0)
		return e;
	if (!(a = room(o, o->of, &o->capo, o->r->ni, sizeof *o->of)))
		return MESH_ENOMEM;
	o->of = a;
	o->of[o->r->ni] = k < INT_MAX ? (int)k : INT_MAX;
	return 0;
}

/* Reads a corner: a, a/b, a//c or a/b/c. */
static int
corner(Obj *o, Token t)
{
	Reader *r = o->r;
	const char *slash = memchr(t.s, '/', t.n);
	const size_t n = slash ? (size_t)(slash - t.s) : t.n;
	long long i;
	size_t k;
	int e;

	for (k = n; k < t.n; k++)
		if (!strchr("/-0123456789", t.s[k]) || !t.s[k])
			return bad(r, "a corner", t);
	if (n == 0)
		return bad(r, "a corner", t);
	if ((e = index_from_0(r, (Token){ t.s, n }, r->s->nv, "vertices", &i)) != 0)
		return e;
	if (r->read_uv && (e = cornertexture(o, slash, t.s + t.n)) != 0)
		return e;
	return soup_corner(r, i);
}

static int
face(Obj *o)
{
	Token t;
	int e;

	while (word(o->r, &t))
		if ((e = corner(o, t)) != 0)
			return e;
	return soup_face(o->r);
}

/* Whether a and b are images of the same point of a folded chart, up to rounding. */
static int
same_point(const double a[2], const double b[2])
{
	Sheet s = sheet_nearest(a[0], a[1], b[0], b[1]);

	return hypot(sheet_u(s, a[0]) - b[0], sheet_v(s, a[1]) - b[1]) < 1e-12;
}

/* The same, also across a fold at v = T. */
static int
same_on(const Soup *s, const double a[2], const double b[2])
{
	const double x[2] = { a[0], s->T - a[1] }, y[2] = { b[0], s->T - b[1] };

	return same_point(a, b) || (s->chart->folded > 1 && same_point(x, y));
}

/* Sets the (u,v) of vertex v from corner c of face f.  All corners at v must have the same (u,v), or images
 * of it; it is then that of vt v. */
static int
assign_uv(Obj *o, int f, int c, int v)
{
	Soup *s = o->r->s;
	int folded = s->chart && s->chart->folded && v < o->nt;
	double *uv = o->r->uv + 2*(size_t)v;
	const double *x;

	if (o->of[c] < 0)
		return mesh_fail(s->err, MESH_EFORMAT, "face %d gives no vt for vertex %d", f, v);
	if (o->of[c] >= o->nt)
		return mesh_fail(s->err, MESH_EINDEX, "face %d refers to vt %d, there are %d", f, o->of[c], o->nt);
	x = o->vt[o->of[c]];
	if (folded && same_on(s, o->vt[v], x))
		x = o->vt[v];
	if ((uv[0] != -1 || uv[1] != -1) && (uv[0] != x[0] || uv[1] != x[1]))
		return mesh_fail(s->err, MESH_EVALUE,
		    "vertex %d has two (u,v), the second in face %d: a seam", v, f);
	memcpy(uv, x, 2 * sizeof *uv);
	return 0;
}

static int
assign_all(Obj *o)
{
	Soup *s = o->r->s;
	int c, e, f;

	if ((e = uv_start(o->r, 0)) != 0)
		return e;
	for (f = 0; f < s->nf; f++)
		for (c = s->first[f]; c < s->first[f+1]; c++)
			if (s->idx[c] < s->nv && (e = assign_uv(o, f, c, s->idx[c])) != 0)
				return e;
	return 0;
}

static int
statements(Obj *o)
{
	Reader *r = o->r;
	Token t;
	int e;

	while (r->hash = 0, scan_token(r, &t)) {
		r->hash = t.n > 0 && *t.s != '#';
		e = 0;
		if (t.n == 1 && *t.s == 'v')
			e = vertex(r);
		else if (t.n == 1 && *t.s == 'f')
			e = face(o);
		else if (r->read_uv && t.n == 2 && memcmp(t.s, "vt", 2) == 0)
			e = texture(o);
		else if (t.n == 1 && *t.s == '#')
			e = uv_comment(r);
		if (e)
			return e;
		scan_skipline(r);
	}
	return r->read_uv ? assign_all(o) : 0;
}

int
obj_recognise(const MeshStart *m)
{
	static const char *const word[] = { "v", "vt", "vn", "vp", "f", "o", "g", "s", "l", "p",
	    "mtllib", "usemtl" };
	size_t i;

	for (i = 0; i < sizeof word / sizeof *word; i++)
		if (scan_is(m->word, word[i]))
			return MESHSTART_MAYBE;
	return MESHSTART_NO;
}

int
obj_read(Reader *r)
{
	Obj o = { .r = r };
	int e = statements(&o);

	free(o.vt);
	free(o.of);
	if (!e && r->s->nv == 0)
		return mesh_fail(r->s->err, MESH_EFORMAT, "OBJ file without vertices");
	return e;
}
