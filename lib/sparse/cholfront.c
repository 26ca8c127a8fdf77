/* cholfront.c - assembly of the front of a node, and back substitution with it. */
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

/* The index of row p of the factor in the ascending list row[n], which contains p. */
static int
find_row(const int *row, int n, int p)
{
	int low = 0, middle;

	while (n > 1) {
		middle = n/2;
		low += row[low + middle] <= p ? middle : 0;
		n -= middle;
	}
	return low;
}

/* The entry of row i of the panel in column 0. */
static inline double *
panel_row(const Front *f, int i)
{
	return f->panel + front_panel(f, i/PRODUCT_ROWS) + i%PRODUCT_ROWS;
}

/* The entry in column 0 of row r of those below the eliminated rows. */
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

/* Fills column k of the front of node s from the matrix and b. */
static void
fill_column(const Chol *c, const CholMatrix *a, const double *b, int s, const Front *f, int k)
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
			below_row(f, find_row(row, f->rows - 1, q))[PRODUCT_ROWS*k] = a->off[e];
	}
}

void
chol_fill_panel(const Chol *c, const CholMatrix *a, const double *b, int s, const Front *f)
{
	int k;

	memset(f->panel, 0, front_panel(f, f->blocks)*sizeof *f->panel);
	for (k = 0; k < f->columns; k++)
		fill_column(c, a, b, s, f, k);
}

/* Maps the rows of a child's update to those of its parent s, whose front is f.  Row i goes to the
 * row of column to[i] of the parent or, if to[i] < 0, to row -1 - to[i] below its columns.  The
 * right-hand side, the last row of the child, goes to the last row of the parent. */
static void
map_rows(const Chol *c, int child, int s, const Front *f, int *to)
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

/* Adds columns j .. end-1 of up to eight rows of a child's update, from row `first` on, to the
 * corresponding rows row[] of its parent. */
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

/* Adds a child's update of n rows to front f.  `to` maps its rows, see map_rows; the first `here`
 * of them are among the columns of f. */
static void
add_update(const Front *f, const double *update, const int *to, int n, int here)
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
chol_add_child(const Chol *c, int child, const double *update, int s, const Front *f)
{
	int n = chol_rows(c, child) + 1, here = 0, *to = malloc(n*sizeof *to);

	if (!to)
		return CHOL_ENOMEM;
	map_rows(c, child, s, f, to);
	while (to[here] >= 0)
		here++;
	add_update(f, update, to, n, here);
	free(to);
	return 0;
}

/* sum(i,k) += a(i,k) x(i) for the eight rows i and n columns k of a row block a. */
static void
add_products(double *sum, const double *a, const double x[PRODUCT_ROWS], int n)
{
	int i, k;

	for (k = 0; k < n; k++, sum += PRODUCT_ROWS, a += PRODUCT_ROWS)
		for (i = 0; i < PRODUCT_ROWS; i++)
			sum[i] += a[i]*x[i];
}

/* Back substitution for the columns of row block J; the results go into z.  On entry, sum has the
 * terms of all later rows.  The terms of row block J are added to the sums of the earlier
 * columns. */
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
	add_products(sum, a, x, PRODUCT_ROWS*J);
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
		add_products(sum, f.panel + front_panel(&f, I), x, f.columns);
	}
	for (I = f.pivots - 1; I >= 0; I--)
		solve_block(&f, I, sum, z + c->first[s]);
}

/* r -= a y for the eight rows and n columns of a row block a. */
static void
subtract_products(double r[PRODUCT_ROWS], const double *a, const double *y, int n)
{
	int i, k;

	for (k = 0; k < n; k++, a += PRODUCT_ROWS)
		for (i = 0; i < PRODUCT_ROWS; i++)
			r[i] -= a[i]*y[k];
}

/* Forward substitution for the columns of row block J; y: the columns of the node. */
static void
forward_block(const Front *f, int J, double *y)
{
	const double *a = f->panel + front_panel(f, J);
	double r[PRODUCT_ROWS] = { 0 };
	int n = f->columns - PRODUCT_ROWS*J, i, k;

	n = n < PRODUCT_ROWS ? n : PRODUCT_ROWS;
	for (i = 0; i < n; i++)
		r[i] = y[PRODUCT_ROWS*J + i];
	subtract_products(r, a, y, PRODUCT_ROWS*J);
	for (a += PRODUCT_ROWS*PRODUCT_ROWS*(size_t)J, k = 0; k < n; k++, a += PRODUCT_ROWS) {
		y[PRODUCT_ROWS*J + k] = r[k]/a[k];
		for (i = k + 1; i < n; i++)
			r[i] -= a[i]*y[PRODUCT_ROWS*J + k];
	}
}

void
chol_forward(const Chol *c, int s, double *b)
{
	const int *row = c->row + c->below[s];
	double *y = b + c->first[s], *a;
	Front f = chol_front(c, s);
	int n = f.rows - 1, I, i, k;

	for (I = 0; I < f.pivots; I++)
		forward_block(&f, I, y);
	for (I = f.pivots; I < f.blocks; I++, row += PRODUCT_ROWS, n -= PRODUCT_ROWS) {
		double r[PRODUCT_ROWS] = { 0 };

		a = f.panel + front_panel(&f, I);
		for (k = 0; n < PRODUCT_ROWS && k < f.columns; k++)
			a[PRODUCT_ROWS*k + n] = y[k];
		subtract_products(r, a, y, f.columns);
		for (i = 0; i < PRODUCT_ROWS && i < n; i++)
			b[row[i]] += r[i];
	}
}
