/* vertexcut.h - the smallest vertex separator within a band.  Private to lib/. */
#ifndef VERTEXCUT_H
#define VERTEXCUT_H

#include "order.h"

enum { CUT_LEFT, CUT_RIGHT, CUT_SEPARATOR };

/* side   in   CUT_SEPARATOR for the band: no edge joins a left vertex to a right one
 *        out  only a smallest set of band vertices that separates left from right remains the
 *             separator; the other band vertices join the side they are connected to
 * work   [6*n] scratch
 *
 * Cannot fail. */
void vertexcut(const Graph *g, signed char *side, int *work);

#endif
