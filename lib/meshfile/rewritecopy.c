/* rewritecopy.c - what copies of both formats need: normals, bytes, numbers, lines. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

int
rewrite_odd(const Copy *c)
{
	return mesh_fail(c->err, MESH_EFORMAT, "its vertices cannot be replaced: it is no OBJ or PLY that has them one to a "
	    "line, or they are beyond a float");
}
