/* xyz.c - XYZ: points without faces, one on each line. */
#include "meshpriv.h"

/* A file is XYZ if its first line has nothing but three numbers or more. */
int
xyz_recognise(const MeshStart *m)
{
	const int n = start_numbers(m);

	return n >= 3 ? MESHSTART_MAYBE : MESHSTART_NO;
}

/* Reads the rest of a line whose first word is t: x y z, then numbers that are skipped, as many as on the
 * first line (normals, colours, intensities). */
static int
point(Reader *r, Token t, int *width)
{
	char show[SCAN_SHOW];
	double x[3], rest;
	int n = 0;

	do
		if (!scan_number(t, n < 3 ? &x[n] : &rest))
			return mesh_fail(r->s->err, MESH_EFORMAT, "line %ld: '%s' is not a coordinate", r->line,
			    scan_show(t, show));
	while (n++, scan_word(r, &t));
	if (r->s->nv == 0)
		*width = n;
	if (n != *width || n < 3)
		return mesh_fail(r->s->err, MESH_EFORMAT, "line %ld: point %d has %d numbers, the first has %d",
		    r->line, r->s->nv, n, *width);
	return soup_vertex(r, x);
}

int
xyz_read(Reader *r)
{
	int e, width = 0;
	Token t;

	r->hash = 1;
	while (scan_token(r, &t))
		if ((e = point(r, t, &width)) != 0)
			return e;
	return 0;
}
