/* held.h - the vertices that the sides and cones of a chart hold while triangles are turned back
 * (doc/mathematics.md 3.5).  Private to this wing. */
#ifndef HELD_H
#define HELD_H

#include "tangle.h"

enum { HELD_ENOMEM = -1 };

/* Sets t->side: on the rectangle the bits of harmonic.h; on the sock SIDE_TOP on its boundary, and a bit
 * for each cone.  Then clamps the places to the chart, and puts the vertices of each side onto it, and
 * the cones to theirs. */
void held_put(const Tangle *t);

/* Adds to t->side the vertices behind inner edges between vertices of one side
 * (pocket.h), puts them onto that side, and makes the places along the boundary follow each other in the
 * order of the loop.  Returns 0 or HELD_ENOMEM. */
int  held_sort(const Tangle *t);

/* Replaces (u,v) by its image within the chart. */
void held_wrap(const Tangle *t, double *u, double *v);

#endif
