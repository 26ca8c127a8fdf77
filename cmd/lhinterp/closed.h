/* closed.h - two closed surfaces laid onto each other, by all their nodes. */
#ifndef CMD_CLOSED_H
#define CMD_CLOSED_H

#include "morph.h"

/* If `aligned`, moves B, the grid b, rigidly onto A, by least squares of the distances between equal nodes over
 * the area.  First the chart of B is laid onto itself in another way if B then fits clearly better; its cones and
 * its nodes are in another order then.  Not aligned, notes that it would.  The positions are those of the start;
 * without them B cannot be aligned, and nothing is noted. */
void closed_fit(const Source *a, Source *b, int aligned);

#endif
