/* split.h - splits a piece of a surface graph in two by a small vertex separator.  Private to
 * lib/. */
#ifndef SPLIT_H
#define SPLIT_H

#include "order.h"

/* A piece of the graph that is being ordered.  name[i] is the number of vertex i in the whole graph.
 * The order of the piece, n such numbers, is written to `order`.  f[2*i], f[2*i+1] are the
 * coordinates f1 and f2 (split.c) of vertex i; they are computed anew if n <= again. */
typedef struct Piece {
	Graph g;
	int  *name, *order, *f;
	int   again;
} Piece;

/* Sets side[i] to CUT_LEFT, CUT_RIGHT or CUT_SEPARATOR (vertexcut.h), so that no edge joins left
 * and right and neither side has all vertices; count[] is the number of each.  work is [6*n]
 * scratch, n > 1.  Returns 1, or 0 if it found no small separator with enough vertices on both
 * sides. */
int split(Piece *p, signed char *side, int count[3], int *work);

#endif
