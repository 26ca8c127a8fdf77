/* clean.c - triangles from the polygons of a file, without those that cannot belong to a surface. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../mesh/fail.h"
#include "../mesh/polygon.h"
#include "../mesh/repair.h"
#include "clean.h"

/* Sets corner to the corners of face f, without those equal to the corner before them.  Returns their
 * number. */
static int
corners_of(const Soup *soup, int f, int *corner)
{
	const int *v = soup->idx + soup->first[f], n = soup->first[f+1] - soup->first[f];
	int i, m = 0;

	for (i = 0; i < n; i++)
		if (v[i] != v[(i + 1)%n])
			corner[m++] = v[i];
	return m;
}

/* Whether a corner is not the number of a vertex. */
static int
no_vertex(const Soup *soup, const int *corner, int n)
{
	int i;

	for (i = 0; i < n; i++)
		if (corner[i] < 0 || corner[i] >= soup->nv)
			return 1;
	return 0;
}

/* The first corner whose position is not finite, or -1. */
static int
not_finite(const Soup *soup, const int *corner, int n)
{
	int i, c;

	for (i = 0; i < n; i++)
		for (c = 0; c < 3; c++)
			if (!isfinite(soup->xyz[3*(size_t)corner[i] + (size_t)c]))
				return corner[i];
	return -1;
}

static int
by_number(const void *a, const void *b)
{
	return *(const int *)a < *(const int *)b ? -1 : *(const int *)a > *(const int *)b;
}

/* Whether a corner occurs twice; sorted is workspace, [n]. */
static int
repeats(const int *corner, int n, int *sorted)
{
	int i;

	if (n == 3)
		return corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0];
	memcpy(sorted, corner, (size_t)n*sizeof *sorted);
	qsort(sorted, (size_t)n, sizeof *sorted, by_number);
	for (i = 1; i < n; i++)
		if (sorted[i] == sorted[i-1])
			return 1;
	return 0;
}

/* Appends a polygon of n > 3 different corners as n - 2 triangles. */
static int
split(Sheet *s, const Soup *soup, int *corner, int n)
{
	Soup one = *soup;
	int first[2] = { 0, n }, *tri = NULL, count, out, i, e;
	char reason[MESH_ERRLEN];

	one.nf = 1, one.first = first, one.idx = corner;
	if ((e = polygon_split_some(&one, &tri, &count, &out, reason)) != 0)
		return mesh_fail(s->err, e, "%s", reason);
	for (i = 0; i < n - 2; i++) {
		int *t = s->tri + 3*(size_t)(s->nf + i);

		if (out)
			t[0] = corner[0], t[1] = corner[i+1], t[2] = corner[i+2];
		else
			memcpy(t, tri + 3*(size_t)i, 3*sizeof *t);
	}
	s->nf += n - 2;
	free(tri);
	return 0;
}

static int
add_face(Sheet *s, const Soup *soup, int f, int *corner, int *sorted, MendReport *r)
{
	const int n = corners_of(soup, f, corner), before = s->nf, gone = no_vertex(soup, corner, n);
	const int at = gone ? -1 : not_finite(soup, corner, n);
	int e = 0;

	if (gone) {
		if (r->missing++ == 0)
			r->missing_at = f;
	} else if (at >= 0) {
		if (r->infinite++ == 0)
			r->infinite_at = at;
	} else if (n < 3 || repeats(corner, n, sorted)) {
		if (r->broken++ == 0)
			r->broken_at = f;
	} else if (n == 3) {
		memcpy(s->tri + 3*(size_t)s->nf++, corner, 3*sizeof *corner);
	} else {
		e = split(s, soup, corner, n);
	}
	if (soup->filled && soup->filled[f])
		memset(s->filled + before, 1, (size_t)(s->nf - before));
	return e;
}

/* A triangle by its places, ascending. */
typedef struct Placed {
	int place[3], face;
} Placed;

static int
by_place(const void *a, const void *b)
{
	const Placed *x = a, *y = b;
	int c;

	for (c = 0; c < 3; c++)
		if (x->place[c] != y->place[c])
			return x->place[c] < y->place[c] ? -1 : 1;
	return x->face < y->face ? -1 : x->face > y->face;
}

/* Sets keep to 1 for each triangle that is the first one on its three places, to 0 for the others. */
static void
mark_first(const Sheet *s, const int *place, Placed *p, unsigned char *keep, MendReport *r)
{
	int f, k;

	for (f = 0; f < s->nf; f++) {
		for (k = 0; k < 3; k++)
			p[f].place[k] = place[s->tri[3*(size_t)f + (size_t)k]];
		p[f].face = f;
		qsort(p[f].place, 3, sizeof *p[f].place, by_number);
	}
	qsort(p, (size_t)s->nf, sizeof *p, by_place);
	for (f = 0; f < s->nf; f++) {
		const int same = f > 0 && memcmp(p[f].place, p[f-1].place, sizeof p[f].place) == 0 &&
		    p[f].place[0] < p[f].place[1] && p[f].place[1] < p[f].place[2];

		keep[p[f].face] = !same;
		if (same && (r->twice++ == 0 || p[f].face < r->twice_at))
			r->twice_at = p[f].face;
	}
}

/* Sets place[v] to the number of the position of vertex v: vertices at equal positions have the same
 * number.  Vertices that are not finite, which no triangle has, count as vertices at 0. */
static int
find_places(const Sheet *s, int *place)
{
	double *x = mesh_alloc(s->err, (size_t)s->nv, 3*sizeof *x);
	size_t i;
	int n, e = MESH_ENOMEM;

	if (x) {
		for (i = 0; i < 3*(size_t)s->nv; i++)
			x[i] = isfinite(s->xyz[i]) ? s->xyz[i] : 0;
		if (repair_weld(s->nv, x, place, &n) == 0)
			e = 0;
		else
			mesh_fail(s->err, MESH_ENOMEM, "no memory to compare %d vertices", s->nv);
	}
	free(x);
	return e;
}

static int
drop_twice(Sheet *s, MendReport *r)
{
	int *place = mesh_alloc(s->err, (size_t)s->nv, sizeof *place), e = MESH_ENOMEM;
	Placed *p = mesh_alloc(s->err, (size_t)s->nf, sizeof *p);
	unsigned char *keep = mesh_alloc(s->err, (size_t)s->nf, 1);

	if (place && p && keep && (e = find_places(s, place)) == 0) {
		mark_first(s, place, p, keep, r);
		e = r->twice ? sheet_keep(s, keep) : 0;
	}
	free(place);
	free(p);
	free(keep);
	return e;
}

static int
allocate(Sheet *s, const Soup *soup)
{
	const size_t most = (size_t)soup->first[soup->nf];      /* more than all triangles */
	int v;

	s->xyz = mesh_alloc(s->err, (size_t)soup->nv, 3*sizeof *s->xyz);
	s->source = mesh_alloc(s->err, (size_t)soup->nv, sizeof *s->source);
	s->tri = mesh_alloc(s->err, most, 3*sizeof *s->tri);
	s->filled = mesh_alloc(s->err, most, 1);
	if (!s->xyz || !s->source || !s->tri || !s->filled)
		return MESH_ENOMEM;
	memcpy(s->xyz, soup->xyz, 3*(size_t)soup->nv*sizeof *s->xyz);
	for (v = 0; v < soup->nv; v++)
		s->source[v] = v;
	memset(s->filled, 0, most);
	s->nv = soup->nv;
	s->nf = 0;
	return 0;
}

static int
count_unused(const Soup *soup, int *used)
{
	int i, n = 0;

	memset(used, 0, (size_t)soup->nv*sizeof *used);
	for (i = 0; i < soup->first[soup->nf]; i++)
		if (soup->idx[i] >= 0 && soup->idx[i] < soup->nv)
			used[soup->idx[i]] = 1;
	for (i = 0; i < soup->nv; i++)
		n += !used[i];
	return n;
}

int
sheet_clean(Sheet *s, const Soup *soup, MendReport *r)
{
	const size_t most = (size_t)soup->first[soup->nf] + (size_t)soup->nv;
	int *corner, *sorted, f, e;

	if ((e = allocate(s, soup)) != 0)
		return e;
	corner = mesh_alloc(s->err, most, sizeof *corner);
	sorted = mesh_alloc(s->err, most, sizeof *sorted);
	e = corner && sorted ? 0 : MESH_ENOMEM;
	if (!e)
		r->unused = count_unused(soup, sorted);
	for (f = 0; !e && f < soup->nf; f++)
		e = add_face(s, soup, f, corner, sorted, r);
	free(corner);
	free(sorted);
	if (!e)
		e = drop_twice(s, r);
	if (!e && s->nf == 0)
		e = mesh_fail(s->err, MESH_EDISK, soup->nf ? "no face is left: %d at vertices that do not exist, "
		    "%d at vertices that are not finite, %d without three different corners" : "no faces",
		    r->missing, r->infinite, r->broken);
	return e;
}
