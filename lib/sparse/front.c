/* front.c - blocked Cholesky of a front, row block by row block. */
#include <math.h>

#include "front.h"

enum {
	PANEL = 8,              /* row blocks of columns that are eliminated at once */
	LARGE = 40,             /* row blocks that are worth tasks */
	GRAIN = 8               /* row blocks a task, even */
};

static int
width(const Front *f, int J)
{
	int left = f->columns - PRODUCT_ROWS*J;

	return J >= f->pivots || left > PRODUCT_ROWS ? PRODUCT_ROWS : left;
}

static double *
tile(const Front *f, int I, int J)
{
	if (J < f->pivots)
		return f->panel + front_panel(f, I) + PRODUCT_ROWS*PRODUCT_ROWS*J;
	return f->update + front_update(I - f->pivots) + PRODUCT_ROWS*PRODUCT_ROWS*(J - f->pivots);
}

/* Tiles (I,J) and, if n is 2, (I+1,J): what the columns of tiles from, .. to-1 take from
 * them. */
static void
subtract(const Front *f, int I, int n, int J, int from, int to)
{
	const double *a[2] = { tile(f, I, from), n > 1 ? tile(f, I + 1, from) : NULL };
	double *c[2] = { tile(f, I, J), n > 1 ? tile(f, I + 1, J) : NULL };
	int end = to < f->pivots ? PRODUCT_ROWS*to : f->columns;

	if (from < to)
		product_subtract(n, width(f, J), end - PRODUCT_ROWS*from, a, tile(f, J, from), c);
}

/* The factor of tile d into its place.  Returns as front_factor. */
static int
root(double *d, int n)
{
	int i, j, k, bad = -1;

	for (k = 0; k < n; k++, d += PRODUCT_ROWS) {
		double pivot = sqrt(d[k]);

		if (!(d[k] > 0 && d[k] < HUGE_VAL) && bad < 0)
			bad = k;
		for (i = 0; i < PRODUCT_ROWS; i++)
			d[i] = i < k ? 0 : d[i]/pivot;
		for (j = k + 1; j < n; j++)
			for (i = j; i < PRODUCT_ROWS; i++)
				d[PRODUCT_ROWS*(j - k) + i] -= d[j]*d[i];
	}
	return bad;
}

/* Columns of tiles from .. to-1 down to row block to-1. */
static int
triangle(const Front *f, int from, int to)
{
	int I, J, e, bad = -1;

	for (J = from; J < to; J++) {
		for (I = J; I < to; I++)
			subtract(f, I, 1, J, from, J);
		e = root(tile(f, J, J), width(f, J));
		if (e >= 0 && bad < 0)
			bad = PRODUCT_ROWS*J + e;
		for (I = J + 1; I < to; I++)
			product_divide(width(f, J), tile(f, J, J), tile(f, I, J));
	}
	return bad;
}

/* The same columns in n row blocks from I on, below. */
static void
below(const Front *f, int I, int n, int from, int to)
{
	int J, i;

	for (J = from; J < to; J++) {
		subtract(f, I, n, J, from, J);
		for (i = I; i < I + n; i++)
			product_divide(width(f, J), tile(f, J, J), tile(f, i, J));
	}
}

/* What these columns take from the rest of n row blocks. */
static void
rest(const Front *f, int I, int n, int from, int to)
{
	int J;

	for (J = to; J <= I; J++)
		subtract(f, I, n, J, from, to);
	if (n > 1)
		subtract(f, I + 1, 1, I + 1, from, to);
}

typedef void Step(const Front *, int I, int n, int from, int to);

/* Row blocks I .. end-1, two by two. */
static void
pairs(const Front *f, int I, int end, int from, int to, Step *step)
{
	for (; I < end; I += 2)
		step(f, I, I + 1 < end ? 2 : 1, from, to);
}

/* All row blocks from `to` on. */
static void
all(const Front *f, int from, int to, Step *step)
{
	int I;

	if (f->blocks - to < LARGE) {
		pairs(f, to, f->blocks, from, to, step);
		return;
	}
	for (I = to; I < f->blocks; I += GRAIN) {
#pragma omp task
		pairs(f, I, I + GRAIN < f->blocks ? I + GRAIN : f->blocks, from, to, step);
	}
#pragma omp taskwait
}

int
front_factor(const Front *f)
{
	int from, to, e, bad = -1;

	for (from = 0; from < f->pivots; from = to) {
		to = from + PANEL < f->pivots ? from + PANEL : f->pivots;
		e = triangle(f, from, to);
		if (e >= 0 && bad < 0)
			bad = e;
		all(f, from, to, below);
		all(f, from, to, rest);
	}
	return bad;
}
