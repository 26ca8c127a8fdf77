/* part.h - splitting a piece of a surface graph in two (vertex separator).  Private to lib/. */
#ifndef PART_H
#define PART_H

#include "order.h"

/* name[i] is vertex i's number in the whole graph, order where the piece's order goes, n
 * names.  f[2*i], f[2*i+1] are its coordinates f1 and f2, found anew when n <= again. */
typedef struct Piece {
	Graph g;
	int  *name, *order, *f;
	int   again;
} Piece;

/* side[i] becomes CUT_LEFT, CUT_RIGHT or CUT_SEPARATOR (vertexcut.h), no edge from left
 * to right and none of both the whole; count[] is how many there are of each.  work is
 * [6*n] scratch, n > 1.  Cannot fail. */
void part(Piece *p, signed char *side, int count[3], int *work);

#endif
