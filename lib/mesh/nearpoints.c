/* nearpoints.c - sorts points by cells; two near points lie in one cell or in two that touch. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "../base/vec3.h"
#include "nearpoints.h"

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

/* The bits of a coordinate as an integer, the same for 0 and -0. */
static int64_t
bits(double x)
{
	int64_t w;

	x += 0.0;
	memcpy(&w, &x, sizeof w);
	return w;
}

/* Sorts the points by cells of the given width; if it is 0, by position. */
static void
make_cells(const double *xyz, const int *list, int n, double width, Cell *cell)
{
	int i, c;

	for (i = 0; i < n; i++) {
		const double *x = xyz + 3*(size_t)list[i];

		for (c = 0; c < 3; c++)
			cell[i].at[c] = width > 0 ? (int64_t)floor(x[c]/width) : bits(x[c]);
		cell[i].v = list[i];
	}
	qsort(cell, (size_t)n, sizeof *cell, by_cell);
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

/* Calls meet for cell[i] and each later point of the array that is at most `distance` away: such a point
 * is in the same cell or in one that touches it. */
static void
meet_beside(const double *xyz, const Cell *cell, int n, int i, double distance, NearMeet *meet, void *to)
{
	int64_t lo[3], hi[3];
	double d[3];
	int k, j;

	for (k = 0; k < 9; k++) {
		lo[0] = hi[0] = cell[i].at[0] + k/3 - 1;
		lo[1] = hi[1] = cell[i].at[1] + k%3 - 1;
		lo[2] = cell[i].at[2] - 1;
		hi[2] = cell[i].at[2] + 1;
		if (compare(hi, cell[i].at) < 0)
			continue;
		for (j = first_from(cell, n, lo); j < n && compare(cell[j].at, hi) <= 0; j++) {
			if (j <= i)
				continue;
			sub3(xyz + 3*(size_t)cell[i].v, xyz + 3*(size_t)cell[j].v, d);
			if (norm3(d) <= distance)
				meet(cell[i].v, cell[j].v, norm3(d), to);
		}
	}
}

/* Whether the numbers of cells of that width fit into 64-bit integers. */
static int
countable(const double *xyz, const int *list, int n, double width)
{
	double most = 0;
	int i, c;

	for (i = 0; i < n; i++)
		for (c = 0; c < 3; c++)
			most = larger(most, fabs(xyz[3*(size_t)list[i] + (size_t)c]));
	return most/width < 1e18;
}

int
nearpoints(const double *xyz, const int *list, int n, double distance, NearMeet *meet, void *to)
{
	Cell *cell = malloc(((size_t)n + 1)*sizeof *cell);
	int i;

	if (!cell)
		return NEARPOINTS_ENOMEM;
	if (distance > 0 && !countable(xyz, list, n, distance))
		distance = 0;
	make_cells(xyz, list, n, distance, cell);
	for (i = 0; i < n; i++)
		if (distance > 0)
			meet_beside(xyz, cell, n, i, distance, meet, to);
		else if (i > 0 && compare(cell[i].at, cell[i-1].at) == 0)
			meet(cell[i-1].v, cell[i].v, 0, to);
	free(cell);
	return 0;
}
