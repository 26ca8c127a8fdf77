/* off.c - the Object File Format of Geomview, ASCII and BINARY. */
#include <string.h>

#include "meshpriv.h"

typedef struct Off {
	Reader *r;
	int  extra;             /* binary: how many numbers follow x y z, as the keyword says */
	int  width;             /* ASCII: the same, as counted at vertex 0 */
	int  big, colours;      /* binary: big-endian; each face ends with a count of colours */
	long long nv, nf;
} Off;

/* Whether t is the keyword [ST][C][N]OFF, or off: texture, colour and normal add 2, 4 and 3 numbers to a
 * vertex.  *extra is their sum, or -1 if the keyword announces other dimensions than three (4 or n).
 * Returns the length of the keyword, 0 if there is none.  The first count may follow without a blank,
 * as in "OFF205 360 0" (ModelNet). */
static size_t
keyword(Token t, int *extra)
{
	const char *begin = t.s;
	size_t i;

	*extra = 0;
	if (t.n > 2 && memcmp(t.s, "ST", 2) == 0)
		t.s += 2, t.n -= 2, *extra += 2;
	if (t.n > 1 && *t.s == 'C')
		t.s++, t.n--, *extra += 4;
	if (t.n > 1 && *t.s == 'N')
		t.s++, t.n--, *extra += 3;
	if (t.n > 1 && (*t.s == '4' || *t.s == 'n'))
		t.s++, t.n--, *extra = -1;
	if (t.n < 3 || (memcmp(t.s, "OFF", 3) != 0 && (t.s > begin || memcmp(t.s, "off", 3) != 0)))
		return 0;
	for (i = 3; i < t.n; i++)
		if (t.s[i] < '0' || t.s[i] > '9')
			return 0;
	return (size_t)(t.s - begin) + 3;
}

static int
bad(Off *o, const char *what, Token t)
{
	char show[SCAN_SHOW];

	return mesh_fail(o->r->s->err, MESH_EFORMAT, "line %ld: '%s' is not %s",
	    o->r->line, scan_show(t, show), what);
}

/* Reads the number of edges, and ignores it.  It may be missing; but a line of one whole number after the
 * line of the faces is the number of edges. */
static int
edges(Off *o)
{
	const Reader here = *o->r;
	long long ne;
	Token t, u;

	if (scan_word(o->r, &t)) {
		if (!scan_int(t, &ne))
			return bad(o, "a number of edges", t);
		return scan_word(o->r, &t) ? bad(o, "expected after the three counts", t) : 0;
	}
	if (!scan_token(o->r, &t) || !scan_int(t, &ne) || scan_word(o->r, &u))
		*o->r = here;
	return 0;
}

static int
counts(Off *o)
{
	Token t = { "", 0 };

	if (!scan_token(o->r, &t))
		return mesh_fail(o->r->s->err, MESH_EFORMAT, "file ends in the header");
	if (!scan_int(t, &o->nv))
		return bad(o, "a number of vertices", t);
	if (!scan_token(o->r, &t))
		return mesh_fail(o->r->s->err, MESH_EFORMAT, "file ends in the header");
	if (!scan_int(t, &o->nf))
		return bad(o, "a number of faces", t);
	return edges(o);
}

/* The number of numbers left on this line, or a negative code. */
static int
leftover(Off *o)
{
	double x;
	Token t;
	int n;

	for (n = 0; scan_word(o->r, &t); n++)
		if (!scan_number(t, &x))
			return bad(o, "a number", t);
	return n;
}

static int
vertex(Off *o)
{
	Reader *r = o->r;
	double x[3];
	Token t;
	int c, n;

	for (c = 0; c < 3; c++) {
		if (!scan_token(r, &t))
			return soup_truncated(r, "vertex", r->s->nv, o->nv);
		if (!scan_number(t, &x[c]))
			return bad(o, "a coordinate", t);
	}
	if ((n = leftover(o)) < 0)
		return n;
	if (r->s->nv == 0)
		o->width = n;
	if (n != o->width)
		return mesh_fail(r->s->err, MESH_EFORMAT,
		    "line %ld: vertex %d has %d numbers, those before have %d",
		    r->line, r->s->nv, 3 + n, 3 + o->width);
	return soup_vertex(r, x);
}

static int
face(Off *o)
{
	Reader *r = o->r;
	long long i, k, n;
	Token t;
	int e;

	if (!scan_token(r, &t))
		return soup_truncated(r, "face", r->s->nf, o->nf);
	if (!scan_int(t, &n) || n < 0)
		return bad(o, "a number of corners", t);
	for (k = 0; k < n; k++) {
		if (!scan_token(r, &t))
			return soup_truncated(r, "face", r->s->nf, o->nf);
		if (!scan_int(t, &i))
			return bad(o, "a vertex number", t);
		if ((e = soup_corner(r, i)) != 0)
			return e;
	}
	if ((e = leftover(o)) < 0)
		return e;
	if (e > 4)
		return mesh_fail(r->s->err, MESH_EFORMAT,
		    "line %ld: %d numbers after the %lld corners of face %d, a colour has at most 4",
		    r->line, e, n, r->s->nf);
	return soup_face(r);
}

/* Reads the records of an ASCII file.  A record begins on a new line and may extend over several
 * lines, until it has three coordinates, or a count and that many corners.  The rest of its last
 * line is skipped: for a vertex any numbers (colour, normal, texture), as many as for the first
 * vertex; for a face up to four numbers, a colour.  So a file with several records on a line is
 * refused, not misread. */
static int
ascii(Off *o)
{
	Reader *r = o->r;
	Token t;
	int e;

	if ((e = counts(o)) != 0)
		return e;
	if ((e = soup_check_count(r, "vertices", o->nv, (scan_left(r) + 1) / 6)) != 0 ||
	    (e = soup_check_count(r, "faces", o->nf, (scan_left(r) + 1) / 2)) != 0 ||
	    (e = soup_reserve(r, (size_t)o->nv, (size_t)o->nf, 0)) != 0)
		return e;
	while (r->s->nv < o->nv)
		if ((e = vertex(o)) != 0)
			return e;
	while (r->s->nf < o->nf)
		if ((e = face(o)) != 0)
			return e;
	return scan_token(r, &t) ? bad(o, "expected after the last face", t) : 0;
}

static long long
word4(const Off *o, const char *p)
{
	return (long long)scan_bytes(p, 4, o->big);
}

/* Whether the bytes from p on, read as faces with colours, end exactly at the end of the file. */
static int
hascolours(const Off *o, const char *p)
{
	long long f, n;

	for (f = 0; f < o->nf; f++) {
		if (o->r->end - p < 4 || (n = word4(o, p)) > (o->r->end - p)/4 - 1)
			return 0;
		p += 4 + 4*n;
		if (o->r->end - p < 4 || (n = word4(o, p)) > 4 || (o->r->end - p)/4 - 1 < n)
			return 0;
		p += 4 + 4*n;
	}
	return p == o->r->end;
}

static int
binface(Off *o)
{
	Reader *r = o->r;
	long long k, n;
	int e;

	n = scan_left(r) >= 4 ? word4(o, r->p) : 0;
	if (scan_left(r) < 4 || (size_t)n > scan_left(r)/4 - 1)
		return soup_truncated(r, "face", r->s->nf, o->nf);
	if (n == 0)             /* in a truncated file, this may be the last face's count of colours */
		return mesh_fail(r->s->err, MESH_EFORMAT, "face %d of %lld has no corners",
		    r->s->nf, o->nf);
	for (k = 0, r->p += 4; k < n; k++, r->p += 4)
		if ((e = soup_corner(r, word4(o, r->p))) != 0)
			return e;
	if (o->colours)
		r->p += 4 + 4*word4(o, r->p);   /* not beyond the end: hascolours checked it */
	return soup_face(r);
}

/* Geomview writes big-endian, with a count of colours after each face; pmp-library and others write
 * little-endian without it.  The byte order is big-endian if the counts, read so, fit the size of
 * the file; otherwise little-endian.  Faces are read with colours if they then end exactly at the
 * end of the file. */
static int
binary(Off *o)
{
	Reader *r = o->r;
	const size_t each = 12 + 4*(size_t)o->extra;
	double x[3];
	int c, e;

	if (scan_left(r) < 12)
		return mesh_fail(r->s->err, MESH_EFORMAT, "file ends in the header");
	for (o->big = 1; o->big >= 0; o->big--) {
		o->nv = word4(o, r->p);
		o->nf = word4(o, r->p + 4);
		if ((size_t)o->nv * each + (size_t)o->nf * 4 <= scan_left(r) - 12)
			break;
	}
	o->big = o->big == 1;
	r->p += 12;
	if ((e = soup_check_count(r, "vertices", o->nv, scan_left(r) / each)) != 0 ||
	    (e = soup_check_count(r, "faces", o->nf, scan_left(r) / 4)) != 0 ||
	    (e = soup_reserve(r, (size_t)o->nv, (size_t)o->nf, 0)) != 0)
		return e;
	for (; r->s->nv < o->nv; r->p += each) {
		for (c = 0; c < 3; c++)
			x[c] = scan_float(r->p + 4*c, 4, o->big);
		if ((e = soup_vertex(r, x)) != 0)
			return e;
	}
	o->colours = hascolours(o, r->p);
	while (r->s->nf < o->nf)
		if ((e = binface(o)) != 0)
			return e;
	if (r->p != r->end)
		return mesh_fail(r->s->err, MESH_EFORMAT, "%zu bytes follow the last face",
		    scan_left(r));
	return 0;
}

int
off_recognise(const MeshStart *m)
{
	int extra;

	return keyword(m->word, &extra) > 0 ? MESHSTART_LIKELY : MESHSTART_NO;
}

int
off_read(Reader *r)
{
	Off o = { .r = r };
	const char *here;
	Token t;

	r->hash = 1;
	scan_token(r, &t);
	r->p = t.s + keyword(t, &o.extra);
	if (o.extra < 0)
		return mesh_fail(r->s->err, MESH_EFORMAT, "only OFF of three dimensions is read");
	here = r->p;
	if (!scan_word(r, &t) || !scan_is(t, "BINARY")) {
		r->p = here;
		return ascii(&o);
	}
	scan_skipline(r);
	if (scan_left(r) > 1 && r->p[0] == '\r' && r->p[1] == '\n')
		r->p++;
	if (r->p < r->end)
		r->p++;
	return binary(&o);
}
