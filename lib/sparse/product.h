/* product.h - products and triangular solves of rows stored in blocks of eight.  Private to lib/.
 *
 * A row block is eight rows of a matrix, column after column: entry (i,k) at [8*k + i].
 */
#ifndef PRODUCT_H
#define PRODUCT_H

enum {
	PRODUCT_ROWS = 8,
	PRODUCT_BLOCKS = 2      /* most row blocks in one call of product_subtract */
};

/* c(i,j) -= sum over k < n of a(i,k) b(j,k), j < columns <= 8, for `blocks` row blocks a and c.
 * All eight rows of b are read; a NaN in row j affects column j of c only.  The order of the sums
 * depends on the processor alone. */
void product_subtract(int blocks, int columns, int n, const double *const a[], const double *b,
	double *const c[]);

/* x = x L'^-1 for a row block x; L is the lower triangle of a row block.  `columns`, at most 8, is
 * the number of columns of both. */
void product_divide(int columns, const double *L, double *x);

#endif
