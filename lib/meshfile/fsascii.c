/* fsascii.c - FreeSurfer ASCII surfaces, as mris_convert writes them: a line "#!ascii version of NAME", the
 * counts, lines "x y z 0", lines "i j k 0".  The last number, which marks what is cut out, is skipped. */
#include <string.h>

#include "meshpriv.h"

static const char MAGIC[] = "#!ascii version of";

int
fsascii_recognise(const MeshStart *m)
{
	return start_has(m, MAGIC, sizeof MAGIC - 1) ? MESHSTART_SURE : MESHSTART_NO;
}

static int
counts(Reader *r, long long *nv, long long *nf)
{
	int e;

	if ((e = record_int(r, "count", 0, 2, nv)) != 0 || (e = record_int(r, "count", 1, 2, nf)) != 0)
		return e;
	if ((e = soup_check_count(r, "vertices", *nv, (scan_left(r) + 1)/8)) != 0)
		return e;
	return soup_check_count(r, "faces", *nf, (scan_left(r) + 1)/8 - (size_t)*nv);
}

static int
face(Reader *r, long long nf)
{
	long long i;
	int c, e;

	for (c = 0; c < 3; c++)
		if ((e = record_int(r, "face", r->s->nf, nf, &i)) != 0 || (e = soup_corner(r, i)) != 0)
			return e;
	return soup_face(r);
}

int
fsascii_read(Reader *r)
{
	char show[SCAN_SHOW];
	long long nv = 0, nf = 0;
	double flag;
	Token t;
	int e;

	r->p += sizeof MAGIC - 1;
	if (scan_word(r, &t) && scan_is(t, "patch"))
		return mesh_fail(r->s->err, MESH_EFORMAT, "a FreeSurfer ASCII patch is not read, only whole surfaces");
	scan_skipline(r);
	r->hash = 1;
	if ((e = counts(r, &nv, &nf)) != 0 || (e = soup_reserve(r, (size_t)nv, (size_t)nf, 3*(size_t)nf)) != 0)
		return e;
	while (r->s->nv < nv)
		if ((e = record_vertex(r, nv)) != 0 || (e = record_number(r, "vertex", r->s->nv - 1, nv, &flag)) != 0)
			return e;
	while (r->s->nf < nf)
		if ((e = face(r, nf)) != 0 || (e = record_number(r, "face", r->s->nf - 1, nf, &flag)) != 0)
			return e;
	if (scan_token(r, &t))
		return mesh_fail(r->s->err, MESH_EFORMAT, "line %ld: '%s' is not expected after the last face", r->line,
		    scan_show(t, show));
	if ((e = fact_add(r, "source", (Token){ "FreeSurfer", 10 })) != 0 ||
	    (e = fact_add(r, "unit", (Token){ "mm", 2 })) != 0)
		return e;
	return fact_add(r, "space", (Token){ "tkras", 5 });
}
