/* cholpriv.h - the front (front.h) of one node of chol.h: assembly and back substitution.  Private
 * to lib/.
 *
 * The last row of every front is the right-hand side b, so that front_factor turns it into L^-1 b.
 */
#ifndef CHOLPRIV_H
#define CHOLPRIV_H

#include "chol.h"
#include "front.h"

/* Number of rows below node s, without the right-hand side. */
static inline int
chol_rows(const Chol *c, int s)
{
	return (int)(c->below[s+1] - c->below[s]);
}

/* The front of node s; its update is NULL. */
Front chol_front(const Chol *c, int s);

/* Fills the panel of node s with its columns of the matrix and, in the last row, with b.  b is [n],
 * by vertex. */
void chol_fill_panel(const Chol *c, const CholMatrix *a, const double *b, int s, const Front *f);

/* Adds the update of a child to the front f of node s.  Returns 0 or CHOL_ENOMEM. */
int  chol_add_child(const Chol *c, int child, const double *update, int s, const Front *f);

/* Forward substitution: replaces b at the columns of node s by L^-1 b, which becomes the right-hand side of the front,
 * and subtracts its part from b at the rows below.  b is [n], by column. */
void chol_forward(const Chol *c, int s, double *b);

/* Back substitution: computes the solution z at the columns of node s from its values at the rows
 * below.  z is [n], by column.  sum is scratch, eight numbers for each column of the node. */
void chol_substitute(const Chol *c, int s, double *z, double *sum);

#endif
