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
	int *first, *low;       /* [n+1], neighbours that are eliminated before a column */
	int *parent, *count;    /* [n] -1: none; entries of a column of L, its diagonal included */
	int *mark;              /* [n+1] scratch */
} Etree;

/* The tree of g eliminated in an order, which becomes a postorder of it: every subtree is
 * a run of columns, its root the last, and the child with the longest column is next
 * to its parent.  Returns 0 or ETREE_ENOMEM; t is to be freed in both cases. */
int  etree_init(Etree *t, const Graph *g, const int *order);
void etree_free(Etree *t);

#endif
