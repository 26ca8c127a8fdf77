/* front.h - elimination of some columns of a dense symmetric matrix.  Private to lib/.
 *
 * A front has `columns` rows and columns to be eliminated and `rows` rows below them.
 * Each part begins a row block (product.h) of its own, the rest of its last one is 0:
 *
 *   panel    the columns: of row block I, those up to its last row
 *   update   the rows below by themselves: of row block A, the columns 0 .. 8*A+7
 *
 * Only the lower triangle counts; what stands above it in blocks on the diagonal is
 * without meaning.
 */
#ifndef FRONT_H
#define FRONT_H

#include <stddef.h>

#include "product.h"

typedef struct Front {
	int     columns, rows;
	int     pivots, blocks; /* row blocks of the columns, and of all */
	double *panel, *update;
} Front;

static inline int
front_blocks(int rows)
{
	return (rows + PRODUCT_ROWS - 1)/PRODUCT_ROWS;
}

/* Where row block I of the panel begins; for I = blocks, how many numbers it has. */
static inline size_t
front_panel(const Front *f, int I)
{
	size_t triangle = I < f->pivots ? I : f->pivots - 1;

	return PRODUCT_ROWS*(PRODUCT_ROWS/2*triangle*(triangle + 1) + (I - triangle)*f->columns);
}

/* The same of the update. */
static inline size_t
front_update(int A)
{
	return PRODUCT_ROWS*PRODUCT_ROWS/2*(size_t)A*(A + 1);
}

/* pivots and blocks from columns > 0 and rows. */
static inline void
front_size(Front *f)
{
	f->pivots = front_blocks(f->columns);
	f->blocks = f->pivots + front_blocks(f->rows);
}

/* The factor of the columns into their place, panel = L, and update -= L L'.  Large fronts
 * are made by tasks, if there is a team; the same bits with and without.
 * Returns -1, or the first column whose pivot is not positive: nothing in the front is
 * a result then. */
int front_factor(const Front *f);

#endif
