/* weld.c - vertices of the boundary at one place, found in cells as wide as the distance. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "../base/vec3.h"
#include "../mesh/fail.h"
#include "join.h"
#include "weld.h"

typedef struct Cell {
	int64_t at[3];
	int     v;
} Cell;

static int
compare(const int64_t a[3], const int64_t b[3])
{
	int c;

	for (c = 0; c < 3; c++)
		if (a[c] != b[c])
			return a[c] < b[c] ? -1 : 1;
	return 0;
}

static int
by_cell(const void *a, const void *b)
{
	const Cell *x = a, *y = b;
	const int order = compare(x->at, y->at);

	return order ? order : x->v < y->v ? -1 : x->v > y->v;
}

/* Marks the vertices on edges of one face; n counts them. */
static int
mark_boundary(const Sheet *s, unsigned char *on, int *n)
{
	Sheet other = *s;
	int many, at[2], e, i;

	other.twin = NULL;
	*n = 0;
	memset(on, 0, (size_t)s->nv);
	if ((e = sheet_join(&other, &many, at, NULL)) == 0)
		for (i = 0; i < 3*s->nf; i++)
			if (other.twin[i] < 0)
				on[s->tri[i]] = on[sheet_to(s, i)] = 1;
	for (i = 0; i < s->nv; i++)
		*n += on[i];
	free(other.twin);
	return e;
}

/* The bits of a coordinate as an integer, the same for 0 and -0. */
static int64_t
bits(double x)
{
	int64_t w;

	x += 0.0;
	memcpy(&w, &x, sizeof w);
	return w;
}

/* The vertices that are marked, sorted by cells of that width; of width 0: by position. */
static Cell *
make_cells(const Sheet *s, const unsigned char *on, int n, double width)
{
	Cell *cell = mesh_alloc(s->err, (size_t)n, sizeof *cell);
	int v, i = 0, c;

	for (v = 0; cell && v < s->nv; v++) {
		if (!on[v])
			continue;
		for (c = 0; c < 3; c++)
			cell[i].at[c] = width > 0 ? (int64_t)floor(sheet_at(s, v)[c]/width)
			    : bits(sheet_at(s, v)[c]);
		cell[i++].v = v;
	}
	if (cell)
		qsort(cell, (size_t)n, sizeof *cell, by_cell);
	return cell;
}

/* The first of the n cells that is not before `at`. */
static int
first_from(const Cell *cell, int n, const int64_t at[3])
{
	int lo = 0, hi = n;

	while (lo < hi) {
		const int mid = lo + (hi - lo)/2;

		if (compare(cell[mid].at, at) < 0)
			lo = mid + 1;
		else
			hi = mid;
	}
	return lo;
}

typedef void Meet(const Sheet *, int v, int w, double distance, void *);

/* Calls meet for each vertex w after v, in the order of cells, that is in a cell beside that of v. */
static void
meet_beside(const Sheet *s, const Cell *cell, int n, int i, Meet *meet, void *to)
{
	int64_t lo[3], hi[3];
	double d[3];
	int k, j;

	for (k = 0; k < 9; k++) {
		lo[0] = hi[0] = cell[i].at[0] + k/3 - 1;
		lo[1] = hi[1] = cell[i].at[1] + k%3 - 1;
		lo[2] = cell[i].at[2] - 1;
		hi[2] = cell[i].at[2] + 1;
		for (j = first_from(cell, n, lo); j < n && compare(cell[j].at, hi) <= 0; j++) {
			if (j <= i)
				continue;
			sub3(sheet_at(s, cell[i].v), sheet_at(s, cell[j].v), d);
			meet(s, cell[i].v, cell[j].v, norm3(d), to);
		}
	}
}

typedef struct Near {
	int    *up;
	double  distance, most, least;
	const int *first, *corner;
} Near;

static void
unite(const Sheet *s, int v, int w, double distance, void *to)
{
	Near *near = to;

	(void)s;
	if (distance <= near->distance)
		sheet_unite(near->up, v, w);
}

static void
unite_equal(const Cell *cell, int n, int *up)
{
	int i;

	for (i = 1; i < n; i++)
		if (compare(cell[i].at, cell[i-1].at) == 0)
			sheet_unite(up, cell[i].v, cell[i-1].v);
}

int
weld_boundary(const Sheet *s, double distance, int *to)
{
	unsigned char *on = mesh_alloc(s->err, (size_t)s->nv, 1);
	Near near = { .up = to, .distance = distance };
	Cell *cell = NULL;
	int v, n, i, merged = 0, e = on ? 0 : MESH_ENOMEM;

	for (v = 0; v < s->nv; v++)
		to[v] = v;
	if (!e)
		e = mark_boundary(s, on, &n);
	if (!e && !(cell = make_cells(s, on, n, distance)))
		e = MESH_ENOMEM;
	if (!e && !(distance > 0))
		unite_equal(cell, n, to);
	for (i = 0; !e && distance > 0 && i < n; i++)
		meet_beside(s, cell, n, i, unite, &near);
	for (v = 0; !e && v < s->nv; v++)
		merged += (to[v] = sheet_root(to, v)) != v;
	free(on);
	free(cell);
	return e ? e : merged;
}

/* Whether v and w are corners of one face. */
static int
share_face(const Sheet *s, const Near *near, int v, int w)
{
	int i, k;

	for (i = near->first[v]; i < near->first[v+1]; i++)
		for (k = 0; k < 3; k++)
			if (s->tri[near->corner[i] - near->corner[i]%3 + k] == w)
				return 1;
	return 0;
}

static void
take_least(const Sheet *s, int v, int w, double distance, void *to)
{
	Near *near = to;

	if (distance > near->distance && distance <= near->most &&
	    (near->least < 0 || distance < near->least) && !share_face(s, near, v, w))
		near->least = distance;
}

double
weld_nearest(const Sheet *s, double distance, double most)
{
	unsigned char *on = mesh_alloc(s->err, (size_t)s->nv, 1);
	Near near = { .distance = distance, .most = most, .least = -1 };
	int *first = NULL, *corner = NULL, n, i;
	Cell *cell = NULL;

	if (on && !mark_boundary(s, on, &n) && (cell = make_cells(s, on, n, most)) != NULL &&
	    !sheet_corners(s->tri, 3*s->nf, s->nv, &first, &corner, s->err)) {
		near.first = first, near.corner = corner;
		for (i = 0; i < n; i++)
			meet_beside(s, cell, n, i, take_least, &near);
	}
	free(on);
	free(cell);
	free(first);
	free(corner);
	return near.least;
}
