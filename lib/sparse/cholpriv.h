/* cholpriv.h - the fronts of chol.h, one by one.  Private to lib/.
 *
 * The right-hand side is the last row of every front: its part of the panel becomes L^-1 b.
 */
#ifndef CHOLPRIV_H
#define CHOLPRIV_H

#include "chol.h"
#include "front.h"

/* Rows below node s, without the right-hand side. */
static inline int
chol_rows(const Chol *c, int s)
{
	return (int)(c->below[s+1] - c->below[s]);
}

/* The front of node s; its update is NULL. */
Front chol_front(const Chol *c, int s);

/* The panel gets the columns of the matrix and of the right-hand side b, [n] by vertex. */
void chol_enter(const Chol *c, const CholMatrix *a, const double *b, int s, const Front *f);

/* The front gets the update of a child.  Returns 0 or CHOL_ENOMEM. */
int  chol_add(const Chol *c, int child, const double *update, int s, const Front *f);

/* The solution z, [n] by column, at the columns of node s, from that at the rows below.
 * sum is scratch, eight numbers a column. */
void chol_substitute(const Chol *c, int s, double *z, double *sum);

#endif
