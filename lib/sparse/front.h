/* front.h - elimination of some columns of a dense symmetric matrix.  Private to lib/.
 *
 * A front has `columns` rows and columns that are eliminated, and `rows` rows below them.  Both
 * groups of rows start with a new row block (product.h); their last row blocks are filled up with
 * 0.
 *
 *   panel    the eliminated columns, all rows; row block I holds the columns 0 .. 8*I+7, or all
 *            columns if there are fewer
 *   update   the other columns, rows below; row block A holds the columns 0 .. 8*A+7
 *
 * Only the lower triangle is used; entries above the diagonal have no meaning.
 */
#ifndef FRONT_H
#define FRONT_H

#include <stddef.h>

#include "product.h"

typedef struct Front {
	int     columns, rows;
	int     pivots, blocks; /* row blocks of the eliminated rows, and of all rows */
	double *panel, *update;
} Front;

static inline int
front_blocks(int rows)
{
	return (rows + PRODUCT_ROWS - 1)/PRODUCT_ROWS;
}

/* Where row block I begins in the panel; for I = blocks, the size of the panel. */
static inline size_t
front_panel(const Front *f, int I)
{
	size_t triangle = I < f->pivots ? I : f->pivots - 1;

	return PRODUCT_ROWS*(PRODUCT_ROWS/2*triangle*(triangle + 1) + (I - triangle)*f->columns);
}

/* Where row block A begins in the update. */
static inline size_t
front_update(int A)
{
	return PRODUCT_ROWS*PRODUCT_ROWS/2*(size_t)A*(A + 1);
}

/* Sets pivots and blocks from columns > 0 and rows. */
static inline void
front_size(Front *f)
{
	f->pivots = front_blocks(f->columns);
	f->blocks = f->pivots + front_blocks(f->rows);
}

/* Factors the panel in place, panel = L, and subtracts L L' from the update.  Large fronts use
 * OpenMP tasks if there is a team of threads; the bits are the same without.  Returns -1 on success.
 * Otherwise returns the first column whose pivot is not positive, and the front is unspecified. */
int front_factor(const Front *f);

#endif
