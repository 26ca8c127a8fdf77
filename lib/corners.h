/* corners.h - the four boundary vertices that become the corners of the rectangle.
 *
 * A corner is given by its place in the boundary loop (0 .. nb-1).  The four go round
 * the loop once, counterclockwise: from corner[0] to corner[1] is the bottom v = 0, then
 * the right side u = 1, the top v = T and the left side u = 0.
 */
#ifndef CORNERS_H
#define CORNERS_H

#include "mesh.h"

enum {
	CORNERS_ENOMEM = -1,
	CORNERS_EINNER = -2,    /* vertex *at is not on the boundary, or does not exist */
	CORNERS_EORDER = -3     /* the vertices do not go round the loop once, or one is doubled */
};

/* Four corners chosen by shape, the same way every time.
 *
 * The turn of the boundary at a vertex is the angle between the two chords that reach
 * 1/40 of the loop's length back and forward from it, so that a ragged edge does not
 * count as a corner.  When the boundary has four clear corners - local maxima of the turn
 * of at least 50 degrees, at least 1/20 of the loop apart, and the next best less than
 * 0.6 of the fourth - these are taken, else four vertices nearest to equal arc length.
 * Either way corner[0] is the one nearest to, or is, the start of the loop: its lowest
 * vertex number.
 *
 * Returns 1 when clear corners were found, 0 for equal arc length, or CORNERS_ENOMEM. */
int corners_auto(const Disk *d, int corner[4]);

/* Four vertex numbers made into places in the loop.  Returns 0, CORNERS_ENOMEM,
 * CORNERS_EINNER or CORNERS_EORDER (a loop gone round clockwise is one, too). */
int corners_given(const Disk *d, const int vertex[4], int corner[4], int *at);

#endif
