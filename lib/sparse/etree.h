/* etree.h - the elimination tree of a graph.  Private to lib/.
 *
 * Column p of the factor L is eliminated p-th; its parent is the row of its first entry
 * below the diagonal.
 */
#ifndef ETREE_H
#define ETREE_H

#include "order.h"

enum { ETREE_ENOMEM = -1 };

typedef struct Etree {
	int  n;
	int *order, *place;     /* [n] vertex of a column, column of a vertex */
	int *first, *low;       /* low[first[p]] .. low[first[p+1]-1]: neighbours of column p that are
	                         * eliminated before it */
	int *parent;            /* [n] -1: none */
	int *count;             /* [n] entries of a column of L, with the diagonal */
	int *mark;              /* [n+1] scratch */
} Etree;

/* The elimination tree of g for an order, with columns renumbered in postorder: every subtree is a
 * run of columns with its root last, and the child with the longest column comes directly before
 * its parent.  Returns 0 or ETREE_ENOMEM; t must be freed in both cases. */
int  etree_init(Etree *t, const Graph *g, const int *order);
void etree_free(Etree *t);

#endif
