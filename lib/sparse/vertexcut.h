/* vertexcut.h - the fewest vertices of a band that part a graph.  Private to lib/. */
#ifndef VERTEXCUT_H
#define VERTEXCUT_H

#include "order.h"

enum { CUT_LEFT, CUT_RIGHT, CUT_SEPARATOR };

/* side   in   CUT_SEPARATOR for the band: no edge joins a left vertex to a right one
 *        out  only the fewest vertices of the band that part what was left from what was
 *             right stay in the separator; the rest of it goes to the side it hangs on
 * work   [6*n] scratch
 *
 * Cannot fail. */
void vertexcut(const Graph *g, signed char *side, int *work);

#endif
