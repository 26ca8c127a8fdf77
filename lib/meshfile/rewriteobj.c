/* rewriteobj.c - copies an OBJ with other coordinates, line by line. */
#include <stdlib.h>
#include <string.h>

#include "rewritepriv.h"

/* Whether the line is a statement of that keyword. */
static int
is_statement(const char *p, const char *end, const char *key)
{
	size_t n = strlen(key);

	while (p < end && (*p == ' ' || *p == '\t'))
		p++;
	return (size_t)(end - p) > n && memcmp(p, key, n) == 0 && (p[n] == ' ' || p[n] == '\t');
}

/* Adds the area vector of face f, the statement at p, to the normals that its corners use.  vn: normals so far. */
static int
use_normals(Copy *c, const char *p, const char *end, int f, int vn, int all)
{
	double n[3];
	const char *q, *slash;
	long long k;
	int a;

	rewrite_area(c, f, n);
	for (p = rewrite_word(p, end); (q = rewrite_word(p, end)) > p; p = q) {
		slash = memchr(p, '/', (size_t)(q - p));
		slash = slash ? memchr(slash + 1, '/', (size_t)(q - slash) - 1) : NULL;
		if (!slash)
			continue;
		if (!scan_int((Token){ slash + 1, (size_t)(q - slash) - 1 }, &k))
			k = 0;
		k = k < 0 ? vn + k : k - 1;
		if (k < 0 || k >= all)
			return mesh_fail(c->err, MESH_EFORMAT, "face %d has a normal that is not there", f);
		for (a = 0; a < 3; a++)
			c->normal[3*k+a] += n[a];
	}
	return 0;
}

/* Sets the normals. */
static int
obj_normals(Copy *c)
{
	const char *p, *end;
	int all = 0, vn = 0, f = 0, e = 0;

	for (p = c->p; p < c->end; p = end) {
		end = rewrite_line(c, p);
		all += is_statement(p, end, "vn");
	}
	c->normal = calloc((size_t)all + 1, 3*sizeof *c->normal);
	if (!c->normal)
		return MESH_ENOMEM;
	for (p = c->p; p < c->end && !e; p = end) {
		end = rewrite_line(c, p);
		vn += is_statement(p, end, "vn");
		if (is_statement(p, end, "f") && f < c->s->nf)
			e = use_normals(c, p, end, f++, vn, all);
	}
	return e;
}

/* Replaces the first three numbers of the statement. */
static int
obj_numbers(Copy *c, const char *key, const char *p, const char *end, const double x[3])
{
	const char *rest = p;
	int k, e = rewrite_append(c, key, strlen(key));

	for (k = 0; k < 4; k++)
		rest = rewrite_word(rest, end);
	for (k = 0; k < 3 && !e; k++)
		e = k > 0 && rewrite_append(c, " ", 1) ? MESH_ENOMEM : rewrite_number(c, x[k]);
	return e ? e : rewrite_append(c, rest, (size_t)(end - rest));
}

int
rewrite_obj(Copy *c)
{
	const char *p, *end, *q;
	int v = 0, vn = 0, e = 0;

	for (p = c->p; p < c->end; p = end) {
		end = rewrite_line(c, p);
		for (q = end; q > p && (q[-1] == '\n' || q[-1] == '\r'); q--)
			;
		if (q > p && q[-1] == '\\')
			return mesh_fail(c->err, MESH_EFORMAT, "a statement is continued by \\ on the next line");
	}
	if ((e = obj_normals(c)) != 0)
		return e;
	for (p = c->p; p < c->end && !e; p = end) {
		end = rewrite_line(c, p);
		if (is_statement(p, end, "v")) {
			if (v == c->s->nv)
				return rewrite_odd(c);
			e = obj_numbers(c, "v ", p, end, c->xyz + 3*(size_t)v);
			v++;
		} else if (is_statement(p, end, "vn")) {
			rewrite_unit(c->normal + 3*(size_t)vn);
			e = obj_numbers(c, "vn ", p, end, c->normal + 3*(size_t)vn);
			vn++;
		} else
			e = rewrite_append(c, p, (size_t)(end - p));
	}
	return !e && v < c->s->nv ? rewrite_odd(c) : e;
}
