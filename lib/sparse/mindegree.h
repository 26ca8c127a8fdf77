/* mindegree.h - a fill-reducing order of a graph by approximate minimum degree.  Private to
 * lib/. */
#ifndef MINDEGREE_H
#define MINDEGREE_H

#include "order.h"

enum { MINDEGREE_ENOMEM = -1 };

/* order   out  [n] vertex order[0] is eliminated first
 *
 * Returns 0 or MINDEGREE_ENOMEM. */
int mindegree(const Graph *g, int *order);

#endif
