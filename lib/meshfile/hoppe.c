/* hoppe.c - the .m meshes of Hoppe and of Gu: lines "Vertex ID x y z {..}" and "Face ID i j k {..}", in which
 * i, j, k are IDs of vertices.  Attributes in braces, and lines of other words, are skipped. */
#include <limits.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "meshpriv.h"

/* The ID of a vertex, and its number in the soup. */
typedef struct Named {
	int id, vertex;
} Named;

typedef struct Hoppe {
	Reader *r;
	Named  *name;           /* [r->s->nv] */
	size_t  cap;
} Hoppe;

static int
bad(Reader *r, const char *need, Token t)
{
	char show[SCAN_SHOW];

	return mesh_fail(r->s->err, MESH_EFORMAT, "line %ld: '%s' is not %s", r->line, scan_show(t, show), need);
}

static int
id(Reader *r, long long *i)
{
	Token t = { "", 0 };

	if (!scan_word(r, &t) || !scan_int(t, i) || *i < 0 || *i >= INT_MAX)
		return bad(r, "an ID", t);
	return 0;
}

static int
vertex(Hoppe *h)
{
	Reader *r = h->r;
	const size_t nv = (size_t)r->s->nv, cap = 2*(nv + 8);
	Token t = { "", 0 };
	long long i;
	double x[3];
	void *p;
	int c, e;

	if ((e = id(r, &i)) != 0)
		return e;
	for (c = 0; c < 3; c++)
		if (!scan_word(r, &t) || !scan_number(t, &x[c]))
			return bad(r, "a coordinate", t);
	if (nv >= h->cap) {
		if (!(p = cap <= SIZE_MAX/2/sizeof *h->name ? realloc(h->name, cap*sizeof *h->name) : NULL))
			return mesh_fail(r->s->err, MESH_ENOMEM, "no memory for %zu IDs", cap);
		h->name = p;
		h->cap = cap;
	}
	h->name[nv] = (Named){ (int)i, (int)nv };
	return soup_vertex(r, x);
}

static int
face(Reader *r)
{
	long long i;
	Token t;
	int e;

	if ((e = id(r, &i)) != 0)
		return e;
	while (scan_word(r, &t) && *t.s != '{') {
		if (!scan_int(t, &i))
			return bad(r, "the ID of a vertex", t);
		if ((e = soup_corner(r, i)) != 0)
			return e;
	}
	return soup_face(r);
}

static int
by_id(const void *a, const void *b)
{
	const Named *x = a, *y = b;

	return (x->id > y->id) - (x->id < y->id);
}

/* Replaces the IDs of the corners by the numbers of their vertices. */
static int
resolve(Hoppe *h)
{
	Soup *s = h->r->s;
	const size_t nv = (size_t)s->nv;
	Named key = { 0, 0 }, *found;
	int f, i;
	size_t v;

	if (nv)
		qsort(h->name, nv, sizeof *h->name, by_id);
	for (v = 1; v < nv; v++)
		if (h->name[v].id == h->name[v-1].id)
			return mesh_fail(s->err, MESH_EFORMAT, "two vertices have the ID %d", h->name[v].id);
	for (f = 0; f < s->nf; f++)
		for (i = s->first[f]; i < s->first[f+1]; i++) {
			key.id = s->idx[i];
			found = nv ? bsearch(&key, h->name, nv, sizeof key, by_id) : NULL;
			if (!found)
				return mesh_fail(s->err, MESH_EINDEX, "face %d refers to the ID %d, which no vertex has", f,
				    key.id);
			s->idx[i] = found->vertex;
		}
	return 0;
}

static int
statements(Hoppe *h)
{
	Reader *r = h->r;
	int e = 0;
	Token t;

	r->hash = 1;
	while (!e && scan_token(r, &t)) {
		if (scan_is(t, "vertex"))
			e = vertex(h);
		else if (scan_is(t, "face"))
			e = face(r);
		else if (!scan_is(t, "edge") && !scan_is(t, "corner"))
			e = bad(r, "Vertex, Face, Edge or Corner", t);
		scan_skipline(r);
	}
	return e;
}

int
hoppe_recognise(const MeshStart *m)
{
	return m->word.n == 6 && memcmp(m->word.s, "Vertex", 6) == 0 ? MESHSTART_LIKELY : MESHSTART_NO;
}

int
hoppe_read(Reader *r)
{
	Hoppe h = { .r = r };
	int e = statements(&h);

	if (!e)
		e = resolve(&h);
	free(h.name);
	return e;
}
