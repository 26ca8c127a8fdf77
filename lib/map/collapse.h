/* collapse.h - draws what is smaller than rounding as a point (doc/mathematics.md 3.5). */
#ifndef COLLAPSE_H
#define COLLAPSE_H

#include "tangle.h"

/* Moves the corners of each bad triangle to one place, and with them all connected vertices that are
 * nearer than some distance; the smallest distance is taken at which no triangle is bad.  Triangles
 * with two corners at one place have no area.  No vertex moves farther than 1e-9; where that is not
 * enough, nothing is moved. */
void collapse(Tangle *t);

#endif
