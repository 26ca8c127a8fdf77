/* soup.c - builds a polygon soup while its file is read. */
#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "meshpriv.h"

/* Enlarges the array *a from *cap to n items of `size` bytes, if n is larger. */
static int
grow(Reader *r, void **a, size_t *cap, size_t n, size_t size)
{
	void *b;

	if (n <= *cap)
		return 0;
	b = n <= SIZE_MAX / 2 / size ? realloc(*a, n * size) : NULL;
	if (!b)
		return mesh_fail(r->s->err, MESH_ENOMEM, "no memory for %zu x %zu bytes", n, size);
	*a = b;
	*cap = n;
	return 0;
}

/* Each of the next three functions enlarges one array of the soup to n items. */
static int
grow_vertices(Reader *r, size_t n)
{
	void *a = r->s->xyz;
	int e = grow(r, &a, &r->capv, n, 3 * sizeof(double));

	r->s->xyz = a;
	return e;
}

static int
grow_faces(Reader *r, size_t n)
{
	void *a = r->s->first;
	int e = grow(r, &a, &r->capf, n, sizeof(int));

	r->s->first = a;
	return e;
}

static int
grow_corners(Reader *r, size_t n)
{
	void *a = r->s->idx;
	int e = grow(r, &a, &r->capi, n, sizeof(int));

	r->s->idx = a;
	return e;
}

/* Reserves one item more than asked for, so that the arrays are allocated even if they stay empty. */
int
soup_reserve(Reader *r, size_t nv, size_t nf, size_t ni)
{
	int e;

	if ((e = grow_vertices(r, r->s->nv + nv + 1)) != 0 || (e = grow_faces(r, r->s->nf + nf + 1)) != 0)
		return e;
	if ((e = grow_corners(r, r->ni + ni + 1)) != 0)
		return e;
	r->s->first[0] = 0;
	return 0;
}

void
soup_trim(Reader *r)
{
	const size_t nf = (size_t)r->s->nf + 1, ni = r->ni + 1;
	int *p;

	if (nf < r->capf && (p = realloc(r->s->first, nf * sizeof *p)))
		r->s->first = p, r->capf = nf;
	if (ni < r->capi && (p = realloc(r->s->idx, ni * sizeof *p)))
		r->s->idx = p, r->capi = ni;
}

static int
too_many(Reader *r, const char *what)
{
	return mesh_fail(r->s->err, MESH_EFORMAT, "more than %d %s", INT_MAX - 1, what);
}

int
soup_vertex(Reader *r, const double x[3])
{
	size_t n = (size_t)r->s->nv;
	int e, c;

	if (n >= INT_MAX - 1)
		return too_many(r, "vertices");
	if (n == r->capv && (e = grow_vertices(r, 2*n + 1)) != 0)
		return e;
	for (c = 0; c < 3; c++) {
		if (!isfinite(x[c]) && !r->loose)
			return mesh_fail(r->s->err, MESH_EVALUE,
			    "vertex %d has a coordinate that is not finite", r->s->nv);
		r->s->xyz[3*n + (size_t)c] = x[c];
	}
	r->s->nv++;
	return 0;
}

int
soup_corner(Reader *r, long long i)
{
	int e;

	if (r->ni >= INT_MAX - 1)
		return too_many(r, "corners");
	if (r->loose && (i < 0 || i > INT_MAX))
		i = -1;
	else if (i < 0 || i > INT_MAX)
		return mesh_fail(r->s->err, MESH_EINDEX, "face %d refers to vertex %lld, there are %d",
		    r->s->nf, i, r->s->nv);
	if (r->ni == r->capi && (e = grow_corners(r, 2*r->ni + 1)) != 0)
		return e;
	r->s->idx[r->ni++] = (int)i;
	return 0;
}

int
soup_face(Reader *r)
{
	size_t n = (size_t)r->s->nf + 1;
	int e;

	if (n >= INT_MAX - 1)
		return too_many(r, "faces");
	if (n == r->capf && (e = grow_faces(r, 2*n)) != 0)
		return e;
	r->s->first[n] = (int)r->ni;
	r->s->nf++;
	return 0;
}

int
soup_strip(Reader *r, Strip *t, long long k)
{
	const int odd = t->turn % 2 == 1;
	int e = 0;

	if (k == -1) {
		t->turn = 0;
		return 0;
	}
	if (t->turn >= 2 && k != t->a && k != t->b && t->a != t->b)
		if ((e = soup_corner(r, odd ? t->b : t->a)) != 0 ||
		    (e = soup_corner(r, odd ? t->a : t->b)) != 0 ||
		    (e = soup_corner(r, k)) != 0 || (e = soup_face(r)) != 0)
			return e;
	t->a = t->b;
	t->b = k;
	t->turn++;
	return 0;
}

int
soup_check_count(Reader *r, const char *what, long long count, size_t room)
{
	if (count < 0)
		return mesh_fail(r->s->err, MESH_EFORMAT, "header announces %lld %s", count, what);
	if ((unsigned long long)count > room)
		return mesh_fail(r->s->err, MESH_EFORMAT,
		    "header announces %lld %s, file has room for %zu", count, what, room);
	return count >= INT_MAX - 1 ? too_many(r, what) : 0;
}

int
soup_truncated(Reader *r, const char *what, long long i, long long count)
{
	return mesh_fail(r->s->err, MESH_EFORMAT, "file ends in %s %lld of %lld", what, i, count);
}
