/* mni.c - the polygons of the MNI (BIC) .obj format, ASCII.
 *
 *     P ambient diffuse specular shininess transparency NV
 *     NV vertices x y z, NV normals x y z, NF
 *     0 and one colour, or 1 and NF colours, or 2 and NV colours, each r g b a
 *     NF numbers: how many corners the faces up to this one have together
 *     the corners
 */
#include "meshpriv.h"

int
mni_recognise(const MeshStart *m)
{
	MeshStart rest = *m;

	if (m->word.n != 1 || *m->word.s != 'P')
		return MESHSTART_NO;
	rest.word.s++;
	return start_numbers(&rest) == 6 ? MESHSTART_LIKELY : MESHSTART_NO;
}

/* Skips n numbers. */
static int
skip(Reader *r, const char *what, long long n)
{
	long long i;
	double x;
	int e;

	for (i = 0; i < n; i++)
		if ((e = record_number(r, what, i, n, &x)) != 0)
			return e;
	return 0;
}

/* Reads a number of records, each of at least `least` bytes, and checks that the file can hold them. */
static int
count(Reader *r, const char *what, size_t least, long long *n)
{
	int e = record_int(r, what, 0, 1, n);

	return e ? e : soup_check_count(r, what, *n, (scan_left(r) + 1) / least);
}

static int
vertices(Reader *r, long long *nv)
{
	int e;

	if ((e = skip(r, "surface property", 5)) != 0 || (e = count(r, "vertices", 12, nv)) != 0 ||
	    (e = soup_reserve(r, (size_t)*nv, 0, 0)) != 0)
		return e;
	while (r->s->nv < *nv)
		if ((e = record_vertex(r, *nv)) != 0)
			return e;
	return skip(r, "normal", 3 * *nv);
}

static int
colours(Reader *r, long long nv, long long nf)
{
	long long how;
	int e = record_int(r, "colour", 0, 1, &how);

	if (e)
		return e;
	if (how < 0 || how > 2)
		return mesh_fail(r->s->err, MESH_EFORMAT, "line %ld: kind of colours %lld, not 0, 1 or 2", r->line, how);
	return skip(r, "colour", 4*(how == 0 ? 1 : how == 1 ? nf : nv));
}

/* Reads the last corner of every face to s->first. */
static int
ends(Reader *r, long long nf)
{
	long long f, end, before = 0;
	int e;

	for (f = 0; f < nf; f++) {
		if ((e = record_int(r, "face", f, nf, &end)) != 0)
			return e;
		if (end < before)
			return mesh_fail(r->s->err, MESH_EFORMAT, "line %ld: face %lld ends at corner %lld, before it begins",
			    r->line, f, end);
		if ((e = soup_check_count(r, "corners", end, (scan_left(r) + 1) / 2)) != 0)
			return e;
		r->s->first[f + 1] = (int)end;
		before = end;
	}
	return soup_reserve(r, 0, 0, (size_t)before);
}

int
mni_read(Reader *r)
{
	char show[SCAN_SHOW];
	long long nv = 0, nf = 0, i;
	int e;
	Token t;

	scan_token(r, &t);                              /* "P" */
	if ((e = vertices(r, &nv)) != 0 || (e = count(r, "faces", 2, &nf)) != 0 ||
	    (e = colours(r, nv, nf)) != 0 || (e = soup_reserve(r, 0, (size_t)nf, 0)) != 0 || (e = ends(r, nf)) != 0)
		return e;
	for (; r->s->nf < nf; r->s->nf++)
		while (r->ni < (size_t)r->s->first[r->s->nf + 1])
			if ((e = record_int(r, "face", r->s->nf, nf, &i)) != 0 || (e = soup_corner(r, i)) != 0)
				return e;
	if (scan_token(r, &t))
		return mesh_fail(r->s->err, MESH_EFORMAT, "line %ld: '%s' is not expected after the last face", r->line,
		    scan_show(t, show));
	return 0;
}
