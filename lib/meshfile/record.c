/* record.c - numbers of the records of text formats. */
#include <string.h>

#include "meshpriv.h"

static int
bad(Reader *r, const char *what, long long i, Token t, const char *need)
{
	char show[SCAN_SHOW];

	return mesh_fail(r->s->err, MESH_EFORMAT, "line %ld, %s %lld: '%s' is not a %s", r->line, what, i,
	    scan_show(t, show), need);
}

int
record_number(Reader *r, const char *what, long long i, long long count, double *x)
{
	Token t;

	if (!scan_token(r, &t))
		return soup_truncated(r, what, i, count);
	return scan_number(t, x) ? 0 : bad(r, what, i, t, "number");
}

int
record_int(Reader *r, const char *what, long long i, long long count, long long *x)
{
	Token t;

	if (!scan_token(r, &t))
		return soup_truncated(r, what, i, count);
	return scan_int(t, x) ? 0 : bad(r, what, i, t, "whole number");
}

int
record_vertex(Reader *r, long long count)
{
	double x[3];
	int c, e;

	for (c = 0; c < 3; c++)
		if ((e = record_number(r, "vertex", r->s->nv, count, &x[c])) != 0)
			return e;
	return soup_vertex(r, x);
}

int
start_has(const MeshStart *m, const char *magic, size_t n)
{
	return m->n >= n && memcmp(m->p, magic, n) == 0;
}

int
start_numbers(const MeshStart *m)
{
	Reader ahead = { .p = m->word.s, .end = m->p + m->n, .hash = 1 };
	double x;
	Token t;
	int n;

	for (n = 0; m->word.n > 0 && scan_word(&ahead, &t); n++)
		if (!scan_number(t, &x) && !(n > 0 && t.s + t.n == m->p + m->n))
			return -1;
	return n;
}
