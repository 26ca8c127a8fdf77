/* closed.h - two closed surfaces laid onto each other, by all their nodes. */
#ifndef CMD_CLOSED_H
#define CMD_CLOSED_H

#include "morph.h"

/* Moves B, the grid b, rigidly onto A if `aligned`, by least squares of the distances between equal nodes over the area.  Notes if B
 * would fit clearly better with its cones in another order.  The positions are those of the start; without them B cannot
 * be aligned, and nothing is noted. */
void closed_fit(const Source *a, Source *b, int aligned);

#endif
