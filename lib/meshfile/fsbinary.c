/* fsbinary.c - FreeSurfer binary triangle surfaces, such as lh.pial: big-endian; three bytes ff ff fe, a
 * line of text and an empty line, the counts, floats x y z, corners; then perhaps tags, of which only
 * the volume geometry is read. */
#include <string.h>

#include "facts.h"
#include "meshpriv.h"

enum { USE_REAL_RAS = 2, SURF_GEOM = 20 };      /* tags, of FreeSurfer's tags.h */

int
fsbinary_recognise(const MeshStart *m)
{
	return start_has(m, "\xff\xff\xfe", 3) ? MESHSTART_SURE : MESHSTART_NO;
}

static int
header(Reader *r, long long *nv, long long *nf)
{
	const char *eol = memchr(r->p, '\n', scan_left(r));
	int e;

	if (!eol)
		return mesh_fail(r->s->err, MESH_EFORMAT, "file ends in the line of text");
	r->p = eol + 1;
	r->p += r->p < r->end && *r->p == '\n';
	if (scan_left(r) < 8)
		return mesh_fail(r->s->err, MESH_EFORMAT, "file ends in the counts");
	*nv = (long long)scan_bytes(r->p, 4, 1);
	*nf = (long long)scan_bytes(r->p + 4, 4, 1);
	r->p += 8;
	if ((e = soup_check_count(r, "vertices", *nv, scan_left(r)/12)) != 0)
		return e;
	return soup_check_count(r, "faces", *nf, scan_left(r)/12 - (size_t)*nv);
}

/* Keeps the line "key = value" of the volume geometry as a fact. */
static int
geometry_line(Reader *r, const char *end)
{
	const char *equal = memchr(r->p, '=', (size_t)(end - r->p));
	char name[FACT_KEY] = "fs.";
	size_t n = 3;

	if (!equal)
		return 0;
	for (; r->p < equal && n < FACT_KEY - 1; r->p++)
		if (*r->p >= 'a' && *r->p <= 'z')
			name[n++] = *r->p;
	name[n] = '\0';
	if (n == 3)
		return 0;
	return fact_add(r, strcmp(name, "fs.cras") == 0 ? "c_ras" : name,
	    (Token){ equal + 1, (size_t)(end - equal) - 1 });
}

/* The eight lines: valid, filename, volume, voxelsize, xras, yras, zras, cras. */
static int
geometry(Reader *r)
{
	const char *end;
	int e, i;

	for (i = 0; i < 8; i++) {
		if (!(end = memchr(r->p, '\n', scan_left(r))))
			return mesh_fail(r->s->err, MESH_EFORMAT, "file ends in line %d of the volume geometry", i);
		if (i == 0 && !(end > r->p && memchr(r->p, '1', (size_t)(end - r->p))))
			return 0;               /* "valid = 0" */
		if ((e = geometry_line(r, end)) != 0)
			return e;
		r->p = end + 1;
	}
	return 0;
}

/* Reads the tags up to the volume geometry.  A tag is a number of 4 bytes; then the first two below have
 * a value of 4 bytes and text, all others a length of 8 bytes and as many bytes. */
static int
tags(Reader *r)
{
	const char *space = "tkras";
	int e = 0, found = 0;

	while (!e && !found && scan_left(r) >= 8) {
		const unsigned long long tag = scan_bytes(r->p, 4, 1);
		unsigned long long n = 0;

		r->p += 4;
		if (tag == USE_REAL_RAS) {
			space = scan_bytes(r->p, 4, 1) ? "scanner" : space;
			r->p += 4;
		} else if (tag == SURF_GEOM) {
			e = geometry(r);
			found = 1;
		} else {
			n = scan_left(r) >= 8 ? scan_bytes(r->p, 8, 1) : 0;
			r->p = scan_left(r) < 8 || n > scan_left(r) - 8 ? r->end : r->p + 8 + n;
		}
	}
	return e ? e : fact_add(r, "space", (Token){ space, strlen(space) });
}

int
fsbinary_read(Reader *r)
{
	long long nv = 0, nf = 0;
	double x[3];
	int c, e;

	if ((e = header(r, &nv, &nf)) != 0 || (e = soup_reserve(r, (size_t)nv, (size_t)nf, 3*(size_t)nf)) != 0)
		return e;
	for (; r->s->nv < nv; r->p += 12) {
		for (c = 0; c < 3; c++)
			x[c] = scan_float(r->p + 4*c, 4, 1);
		if ((e = soup_vertex(r, x)) != 0)
			return e;
	}
	for (; r->s->nf < nf; r->p += 12) {
		for (c = 0; c < 3; c++)
			if ((e = soup_corner(r, (long long)scan_bytes(r->p + 4*c, 4, 1))) != 0)
				return e;
		if ((e = soup_face(r)) != 0)
			return e;
	}
	if ((e = fact_add(r, "source", (Token){ "FreeSurfer", 10 })) != 0 ||
	    (e = fact_add(r, "unit", (Token){ "mm", 2 })) != 0)
		return e;
	return tags(r);
}
