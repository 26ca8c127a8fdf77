/* product.h - products and quotients of rows kept eight by eight.  Private to lib/.
 *
 * A row block is eight rows of a matrix, column after column: entry (i,k) at [8*k + i].
 */
#ifndef PRODUCT_H
#define PRODUCT_H

enum {
	PRODUCT_ROWS = 8,
	PRODUCT_BLOCKS = 2      /* row blocks that product_subtract takes at most */
};

/* c(i,j) -= sum over k < n of a(i,k) b(j,k), j < columns <= 8, for `blocks` row blocks a
 * and c.  All eight rows of b are read; what is not a number there does no harm to columns
 * that are not its own.  The order of the sums depends on the processor alone. */
void product_subtract(int blocks, int columns, int n, const double *const a[], const double *b,
	double *const c[]);

/* x = x L'^-1: the row block x divided by the lower triangle of the row block L, of so many
 * columns, <= 8. */
void product_divide(int columns, const double *L, double *x);

#endif
