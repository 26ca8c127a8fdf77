/* front.c - blocked Cholesky factorization of a front, in tiles of 8 x 8. */
#include <math.h>

#include "front.h"

enum {
	GROUP = 8,              /* tile columns that are eliminated together */
	LARGE = 40,             /* tasks are used for at least this many row blocks */
	GRAIN = 8               /* row blocks in a task; even, because they are taken in pairs */
};

/* Columns of the tiles in tile column J: eight, or fewer at the end of the panel. */
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

/* Subtracts the products of tile columns `from` .. `to`-1 from tile (I,J) and, if n is 2, from
 * (I+1,J). */
static void
subtract(const Front *f, int I, int n, int J, int from, int to)
{
	const double *a[2] = { tile(f, I, from), n > 1 ? tile(f, I + 1, from) : NULL };
	double *c[2] = { tile(f, I, J), n > 1 ? tile(f, I + 1, J) : NULL };
	int end = to < f->pivots ? PRODUCT_ROWS*to : f->columns;

	if (from < to)
		product_subtract(n, width(f, J), end - PRODUCT_ROWS*from, a, tile(f, J, from), c);
}

/* Replaces the diagonal tile d, n columns wide, by its Cholesky factor.  Returns what front_factor
 * returns. */
static int
factor_tile(double *d, int n)
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

/* Computes the factor in tile columns `from` .. `to`-1, down to row block `to`-1. */
static int
factor_triangle(const Front *f, int from, int to)
{
	int I, J, e, bad = -1;

	for (J = from; J < to; J++) {
		for (I = J; I < to; I++)
			subtract(f, I, 1, J, from, J);
		e = factor_tile(tile(f, J, J), width(f, J));
		if (e >= 0 && bad < 0)
			bad = PRODUCT_ROWS*J + e;
		for (I = J + 1; I < to; I++)
			product_divide(width(f, J), tile(f, J, J), tile(f, I, J));
	}
	return bad;
}

/* Computes the factor in tile columns `from` .. `to`-1 of the row blocks I .. I+n-1, with I >=
 * to. */
static void
divide_below(const Front *f, int I, int n, int from, int to)
{
	int J, i;

	for (J = from; J < to; J++) {
		subtract(f, I, n, J, from, J);
		for (i = I; i < I + n; i++)
			product_divide(width(f, J), tile(f, J, J), tile(f, i, J));
	}
}

/* Subtracts the products of tile columns `from` .. `to`-1 from all later columns of the row blocks
 * I .. I+n-1. */
static void
subtract_group(const Front *f, int I, int n, int from, int to)
{
	int J;

	for (J = to; J <= I; J++)
		subtract(f, I, n, J, from, to);
	if (n > 1)
		subtract(f, I + 1, 1, I + 1, from, to);
}

/* divide_below or subtract_group, for n <= 2 row blocks. */
typedef void Step(const Front *, int I, int n, int from, int to);

/* Applies step to row blocks I .. end-1, two at a time. */
static void
each_pair(const Front *f, int I, int end, int from, int to, Step *step)
{
	for (; I < end; I += 2)
		step(f, I, I + 1 < end ? 2 : 1, from, to);
}

/* Applies step to all row blocks from `to` on, in tasks if there are many. */
static void
each_block(const Front *f, int from, int to, Step *step)
{
	int I;

	if (f->blocks - to < LARGE) {
		each_pair(f, to, f->blocks, from, to, step);
		return;
	}
	for (I = to; I < f->blocks; I += GRAIN) {
#pragma omp task
		each_pair(f, I, I + GRAIN < f->blocks ? I + GRAIN : f->blocks, from, to, step);
	}
#pragma omp taskwait
}

int
front_factor(const Front *f)
{
	int from, to, e, bad = -1;

	for (from = 0; from < f->pivots; from = to) {
		to = from + GROUP < f->pivots ? from + GROUP : f->pivots;
		e = factor_triangle(f, from, to);
		if (e >= 0 && bad < 0)
			bad = e;
		each_block(f, from, to, divide_below);
		each_block(f, from, to, subtract_group);
	}
	return bad;
}
