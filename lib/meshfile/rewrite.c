/* rewrite.c - copies a mesh file line by line, or record by record, with other coordinates. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "meshfile.h"
#include "rewrite.h"
#include "rewritepriv.h"

void
rewrite_area(const Copy *c, int f, double n[3])
{
	const int *v;
	int count = text_corners(c->s, f, &v), k, a;

	n[0] = n[1] = n[2] = 0;
	for (k = 0; k < count; k++) {
		const double *x = c->xyz + 3*(size_t)v[k], *y = c->xyz + 3*(size_t)v[(k+1)%count];

		for (a = 0; a < 3; a++)
			n[a] += (x[(a+1)%3] - c->xyz[3*(size_t)v[0]+(size_t)(a+1)%3])*(y[(a+2)%3] - x[(a+2)%3])
			    - (x[(a+2)%3] - c->xyz[3*(size_t)v[0]+(size_t)(a+2)%3])*(y[(a+1)%3] - x[(a+1)%3]);
	}
}

void
rewrite_unit(double n[3])
{
	double length = sqrt(n[0]*n[0] + n[1]*n[1] + n[2]*n[2]);
	int a;

	for (a = 0; a < 3; a++)
		n[a] = length > 0 ? n[a]/length : a == 2;
}

int
rewrite_append(Copy *c, const char *p, size_t n)
{
	size_t k;

	for (; n > 0; n -= k, p += k) {
		if (!text_room(&c->t))
			return MESH_ENOMEM;
		k = n < TEXT_MAX ? n : TEXT_MAX;
		memcpy(c->t.p + c->t.n, p, k);
		c->t.n += k;
	}
	return 0;
}

int
rewrite_number(Copy *c, double x)
{
	int digits = 15;
	char s[40];

	do
		snprintf(s, sizeof s, "%.*g", digits, x);
	while (strtod(s, NULL) != x && ++digits <= 17);
	return rewrite_append(c, s, strlen(s));
}

const char *
rewrite_line(const Copy *c, const char *p)
{
	const char *lf = memchr(p, '\n', (size_t)(c->end - p));

	return lf ? lf + 1 : c->end;
}

static int
is_blank(char c)
{
	return c == ' ' || c == '\t';
}

const char *
rewrite_word(const char *p, const char *end)
{
	while (p < end && is_blank(*p))
		p++;
	while (p < end && !is_blank(*p) && *p != '\r' && *p != '\n')
		p++;
	return p;
}

/* Whether the copy has the new positions, as doubles or rounded to floats: in all files that are laid out as people
 * write them.  *e is set to 0, or to why the copy cannot be read. */
static int
has_positions(const Copy *c, int *e)
{
	size_t i, n = 3*(size_t)c->s->nv;
	Soup s;

	if ((*e = meshfile_parse(&s, c->t.p, c->t.n, MESHFILE_MOST)) != 0)
		return 0;
	for (i = 0; s.nv == c->s->nv && i < n && (s.xyz[i] == c->xyz[i] || s.xyz[i] == (double)(float)c->xyz[i]); i++)
		;
	soup_free(&s);
	return i == n;
}

int
rewrite_odd(const Copy *c)
{
	return mesh_fail(c->err, MESH_EFORMAT, "its vertices cannot be replaced: it is no OBJ or PLY that has them one to a "
	    "line, or they are beyond a float");
}

static int
copy(Copy *c, int is_ply)
{
	int e = is_ply ? rewrite_ply(c) : rewrite_obj(c), why;

	if (e || has_positions(c, &why))
		return e;
	if (why == MESH_ENOMEM)
		return why;
	return rewrite_odd(c);
}

int
rewrite(const char *bytes, size_t n, int nv, const double *xyz, char **out, size_t *outn, char err[MESH_ERRLEN])
{
	Soup s;
	Copy c = { bytes, bytes + n, &s, xyz, NULL, { NULL, 0, 0 }, err };
	int is_ply = n > 4 && memcmp(bytes, "ply", 3) == 0, e = meshfile_parse(&s, bytes, n, MESHFILE_MOST);

	if (e) {
		snprintf(err, MESH_ERRLEN, "%s", s.err);
		return e;
	}
	if (n > 1 && (unsigned char)bytes[0] == 0x1f)
		e = mesh_fail(err, MESH_EFORMAT, "the file is gzipped: gunzip it first");
	else if (s.nv != nv)
		e = mesh_fail(err, MESH_EFORMAT, "the file has %d vertices, the mesh with (u,v) has %d", s.nv, nv);
	else
		e = copy(&c, is_ply);
	soup_free(&s);
	free(c.normal);
	if (e == MESH_ENOMEM)
		mesh_fail(err, e, "no memory for %zu bytes", n);
	if (e) {
		free(c.t.p);
		return e;
	}
	*out = c.t.p;
	*outn = c.t.n;
	return 0;
}
