/* rewrite.c - copies a mesh file line by line, or record by record, with other coordinates. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "meshfile.h"
#include "rewrite.h"
#include "rewritepriv.h"

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
