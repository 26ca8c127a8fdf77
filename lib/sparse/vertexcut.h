/* vertexcut.h - the smallest vertex separator within a band.  Private to lib/. */
#ifndef VERTEXCUT_H
#define VERTEXCUT_H

#include "order.h"

enum { CUT_LEFT, CUT_RIGHT, CUT_SEPARATOR };

/* side   in   CUT_SEPARATOR for the band: no edge joins a left vertex to a right one
 *        out  CUT_SEPARATOR only for a smallest set of band vertices that separates left from
 *             right; the other band vertices are left or right
 * work   [6*n] scratch
 *
 * Cannot fail. */
void vertexcut(const Graph *g, signed char *side, int *work);

#endif
