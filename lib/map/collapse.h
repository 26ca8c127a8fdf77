/* collapse.h - collapses clusters of vertices around bad triangles (doc/mathematics.md 3.5). */
#ifndef COLLAPSE_H
#define COLLAPSE_H

#include "tangle.h"

/* For each bad triangle, moves the ends of its shortest edge to one place, together with all connected
 * vertices within some distance of them.  The distance begins with the length of that edge and is
 * doubled until no triangle at these vertices is bad.  Triangles with two corners at one place have no
 * area.  No vertex moves farther than 1e-6; where that is not enough, nothing is moved. */
void collapse(Tangle *t);

#endif
