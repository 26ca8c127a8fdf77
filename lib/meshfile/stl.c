/* stl.c - STL, ASCII and binary: triangles, each with three vertices of its own. */
#include <string.h>

#include "meshpriv.h"

enum { HEAD = 84, EACH = 50 };

/* The size in bytes of a binary file, computed from the triangle count in its header.  p has its
 * first n bytes.  0 if n is less than the header. */
static unsigned long long
binary_size(const char *p, size_t n)
{
	return n >= HEAD ? HEAD + EACH*scan_bytes(p + 80, 4, 0) : 0;
}

/* Binary files are recognised by their size, since many of them begin with "solid", too.  Binary
 * data with a plausible triangle count but the wrong size are taken for a damaged STL file. */
int
stl_recognise(const MeshStart *m)
{
	const unsigned long long size = binary_size(m->p, m->n);

	if (size && size >= m->least && size <= m->most)
		return MESHSTART_SURE;
	if (scan_is(m->word, "solid"))
		return MESHSTART_LIKELY;
	return m->least == m->most && size && size < HEAD + EACH*100000000ULL && memchr(m->p, '\0', HEAD) ?
	    MESHSTART_LIKELY : MESHSTART_NO;
}

static int
triangle(Reader *r)
{
	int c, e;

	for (c = 3; c > 0; c--)
		if ((e = soup_corner(r, r->s->nv - c)) != 0)
			return e;
	return soup_face(r);
}

static int
binary(Reader *r)
{
	const size_t n = (scan_left(r) - HEAD) / EACH;
	double x[3];
	int c, e, k;

	if ((e = soup_check_count(r, "triangles", (long long)n, n)) != 0 ||
	    (e = soup_reserve(r, 3*n, n, 3*n)) != 0)
		return e;
	for (r->p += HEAD; r->p < r->end; r->p += EACH) {
		for (k = 1; k <= 3; k++) {              /* the normal, at k = 0, is skipped */
			for (c = 0; c < 3; c++)
				x[c] = scan_float(r->p + 12*k + 4*c, 4, 0);
			if ((e = soup_vertex(r, x)) != 0)
				return e;
		}
		if ((e = triangle(r)) != 0)
			return e;
	}
	return 0;
}

static int
expect(Reader *r, const char *word)
{
	char show[SCAN_SHOW];
	Token t;

	if (!scan_token(r, &t))
		return mesh_fail(r->s->err, MESH_EFORMAT, "file ends in facet %d: no '%s'",
		    r->s->nf, word);
	if (!scan_is(t, word))
		return mesh_fail(r->s->err, MESH_EFORMAT, "line %ld, facet %d: '%s' where '%s' belongs",
		    r->line, r->s->nf, scan_show(t, show), word);
	return 0;
}

static int
numbers(Reader *r, double x[3])
{
	char show[SCAN_SHOW];
	Token t;
	int c;

	for (c = 0; c < 3; c++) {
		if (!scan_token(r, &t))
			return mesh_fail(r->s->err, MESH_EFORMAT, "file ends in facet %d", r->s->nf);
		if (!scan_number(t, &x[c]))
			return mesh_fail(r->s->err, MESH_EFORMAT,
			    "line %ld, facet %d: '%s' is not a number",
			    r->line, r->s->nf, scan_show(t, show));
	}
	return 0;
}

/* Reads the rest of a facet, after the word "facet". */
static int
facet(Reader *r)
{
	double x[3];
	int e, k;

	if ((e = expect(r, "normal")) != 0 || (e = numbers(r, x)) != 0 ||
	    (e = expect(r, "outer")) != 0 || (e = expect(r, "loop")) != 0)
		return e;
	for (k = 0; k < 3; k++)
		if ((e = expect(r, "vertex")) != 0 || (e = numbers(r, x)) != 0 ||
		    (e = soup_vertex(r, x)) != 0)
			return e;
	if ((e = expect(r, "endloop")) != 0 || (e = expect(r, "endfacet")) != 0)
		return e;
	return triangle(r);
}

/* All solids of a file go into one soup. */
static int
ascii(Reader *r)
{
	char show[SCAN_SHOW];
	int e = 0, open = 0;
	Token t;

	while (!e && scan_token(r, &t)) {
		if (open && scan_is(t, "facet")) {
			e = facet(r);
		} else if (scan_is(t, open ? "endsolid" : "solid")) {
			open = !open;
			scan_skipline(r);
		} else {
			e = mesh_fail(r->s->err, MESH_EFORMAT, "line %ld: '%s' where '%s' belongs",
			    r->line, scan_show(t, show), open ? "facet" : "solid");
		}
	}
	if (!e && open)
		e = mesh_fail(r->s->err, MESH_EFORMAT, "file ends after facet %d: no 'endsolid'",
		    r->s->nf - 1);
	return e;
}

int
stl_read(Reader *r)
{
	const size_t n = scan_left(r);

	if (n >= HEAD && binary_size(r->p, n) == n)
		return binary(r);
	if (n > HEAD && memchr(r->p, '\0', HEAD))
		return mesh_fail(r->s->err, MESH_EFORMAT,
		    "binary STL of %llu triangles has %llu bytes, not %zu", scan_bytes(r->p + 80, 4, 0),
		    binary_size(r->p, n), n);
	return ascii(r);
}
