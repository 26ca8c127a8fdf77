/* cholfront.c - assembly of the front of a node, and back substitution from it. */
#include <stdlib.h>
#include <string.h>

#include "cholpriv.h"

Front
chol_front(const Chol *c, int s)
{
	Front f = { .columns = c->first[s+1] - c->first[s], .rows = chol_rows(c, s) + 1,
	    .panel = c->value + c->at[s] };

	front_size(&f);
	return f;
}

/* Where row p of the factor stands among n rows, in which it is. */
static int
find(const int *row, int n, int p)
{
	int low = 0, middle;

	while (n > 1) {
		middle = n/2;
		low += row[low + middle] <= p ? middle : 0;
		n -= middle;
	}
	return low;
}

/* Row i of the panel, at its column 0. */
static inline double *
panel_row(const Front *f, int i)
{
	return f->panel + front_panel(f, i/PRODUCT_ROWS) + i%PRODUCT_ROWS;
}

/* The first place of row r below the columns. */
static inline double *
below_row(const Front *f, int r)
{
	return panel_row(f, PRODUCT_ROWS*f->pivots + r);
}

static inline double *
update_row(const Front *f, int r)
{
	return f->update + front_update(r/PRODUCT_ROWS) + r%PRODUCT_ROWS;
}

/* Column k of the front of node s, from the matrix. */
static void
enter(const Chol *c, const CholMatrix *a, const double *b, int s, const Front *f, int k)
{
	const unsigned char *held = a->held;
	const int *row = c->row + c->below[s];
	int p = c->first[s] + k, i = c->order[p], e, q;

	panel_row(f, k)[PRODUCT_ROWS*k] = held && held[i] ? 1 : a->diagonal[i];
	below_row(f, f->rows - 1)[PRODUCT_ROWS*k] = b[i];
	for (e = held && held[i] ? c->g->first[i+1] : c->g->first[i]; e < c->g->first[i+1]; e++) {
		q = c->place[c->g->adj[e]];
		if (q < p || (held && held[c->g->adj[e]]))
			continue;
		if (q < c->first[s+1])
			panel_row(f, q - c->first[s])[PRODUCT_ROWS*k] = a->off[e];
		else
			below_row(f, find(row, f->rows - 1, q))[PRODUCT_ROWS*k] = a->off[e];
	}
}

void
chol_enter(const Chol *c, const CholMatrix *a, const double *b, int s, const Front *f)
{
	int k;

	memset(f->panel, 0, front_panel(f, f->blocks)*sizeof *f->panel);
	for (k = 0; k < f->columns; k++)
		enter(c, a, b, s, f, k);
}

/* Rows of a child in its parent's front f: to[i] says where row i of the child's update
 * goes, counted from the parent's first column or, less than 0, as -1 - (row below). */
static void
match(const Chol *c, int child, int s, const Front *f, int *to)
{
	const int *row = c->row + c->below[child], *mine = c->row + c->below[s];
	int n = chol_rows(c, child), i, k = 0;

	for (i = 0; i < n; i++) {
		if (row[i] < c->first[s+1]) {
			to[i] = row[i] - c->first[s];
			continue;
		}
		while (mine[k] != row[i])
			k++;
		to[i] = -1 - k;
	}
	to[n] = -f->rows;
}

/* Eight rows of a child's update, columns j .. end-1, added to rows of the parent's. */
static inline void
scatter(double *const row[], int rows, const double *from, const int *to, int j, int end, int first)
{
	int i;

	for (; j < end; j++) {
		int at = PRODUCT_ROWS*(to[j] < 0 ? -1 - to[j] : to[j]);
		const double *column = from + PRODUCT_ROWS*j;

		for (i = j > first ? j - first : 0; i < rows; i++)
			row[i][at] += column[i];
	}
}

/* The update of a child, of n rows, to where `to` says; `here` of its rows are columns of
 * the parent. */
static void
add_child(const Front *f, const double *update, const int *to, int n, int here)
{
	double *row[PRODUCT_ROWS];
	int first, i, rows, end;

	for (first = 0; first < n; first += PRODUCT_ROWS) {
		const double *from = update + front_update(first/PRODUCT_ROWS);

		rows = n - first < PRODUCT_ROWS ? n - first : PRODUCT_ROWS;
		end = first + rows;
		for (i = 0; i < rows; i++)
			row[i] = to[first+i] < 0 ? below_row(f, -1 - to[first+i]) : panel_row(f, to[first+i]);
		scatter(row, rows, from, to, 0, here < end ? here : end, first);
		if (here >= end)
			continue;
		for (i = 0; i < rows; i++)
			if (to[first+i] < 0)
				row[i] = update_row(f, -1 - to[first+i]);
		scatter(row, rows, from, to, here, end, first);
	}
}

int
chol_add(const Chol *c, int child, const double *update, int s, const Front *f)
{
	int n = chol_rows(c, child) + 1, here = 0, *to = malloc(n*sizeof *to);

	if (!to)
		return CHOL_ENOMEM;
	match(c, child, s, f, to);
	while (to[here] >= 0)
		here++;
	add_child(f, update, to, n, here);
	free(to);
	return 0;
}

/* sum += a x for the n columns of a row block, each of its rows by itself. */
static void
gather(double *sum, const double *a, const double x[PRODUCT_ROWS], int n)
{
	int i, k;

	for (k = 0; k < n; k++, sum += PRODUCT_ROWS, a += PRODUCT_ROWS)
		for (i = 0; i < PRODUCT_ROWS; i++)
			sum[i] += a[i]*x[i];
}

/* The solution L'x = sum of the columns of row block J, into z; those from block J+1 on
 * have been taken. */
static void
solve_block(const Front *f, int J, double *sum, double *z)
{
	const double *a = f->panel + front_panel(f, J);
	double x[PRODUCT_ROWS] = { 0 }, y;
	int k, i, n = f->columns - PRODUCT_ROWS*J;

	for (k = (n < PRODUCT_ROWS ? n : PRODUCT_ROWS) - 1; k >= 0; k--) {
		const double *column = a + PRODUCT_ROWS*(PRODUCT_ROWS*J + k);

		for (y = 0, i = 0; i < PRODUCT_ROWS; i++)
			y -= sum[PRODUCT_ROWS*(PRODUCT_ROWS*J + k) + i];
		for (i = k + 1; i < PRODUCT_ROWS; i++)
			y -= column[i]*x[i];
		z[PRODUCT_ROWS*J + k] = x[k] = y/column[k];
	}
	gather(sum, a, x, PRODUCT_ROWS*J);
}

void
chol_substitute(const Chol *c, int s, double *z, double *sum)
{
	const int *row = c->row + c->below[s];
	double x[PRODUCT_ROWS];
	Front f = chol_front(c, s);
	int n = f.rows - 1, I, i;

	memset(sum, 0, PRODUCT_ROWS*(size_t)f.columns*sizeof *sum);
	for (I = f.pivots; I < f.blocks; I++, row += PRODUCT_ROWS, n -= PRODUCT_ROWS) {
		for (i = 0; i < PRODUCT_ROWS; i++)
			x[i] = i < n ? z[row[i]] : i == n ? -1 : 0;
		gather(sum, f.panel + front_panel(&f, I), x, f.columns);
	}
	for (I = f.pivots - 1; I >= 0; I--)
		solve_block(&f, I, sum, z + c->first[s]);
}
