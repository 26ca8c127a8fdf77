/* corners.h - the four boundary vertices that become the corners of the rectangle.
 *
 * A corner is given as an index into the boundary loop (0 .. nb-1).  The four corners go round the
 * loop once, counterclockwise.  The bottom v = 0 runs from corner[0] to corner[1], the right side u
 * = 1 to corner[2], the top v = T to corner[3], and the left side u = 0 back to corner[0].
 */
#ifndef CORNERS_H
#define CORNERS_H

#include "../mesh/mesh.h"

enum {
	CORNERS_ENOMEM = -1,
	CORNERS_EINNER = -2,    /* vertex *at is not on the boundary, or does not exist */
	CORNERS_EORDER = -3,    /* the vertices do not go round the loop once, or two are equal */
	CORNERS_EFEW   = -4     /* a boundary of three vertices */
};

/* Chooses four corners by the shape of the boundary (doc/mathematics.md 3.4).
 *
 * The turn of the boundary at a vertex is the angle between two chords: from the point one reach
 * back along the loop to the vertex, and from the vertex to the point one reach forward.  It is
 * negative at reentrant corners.  The first reach is 1/40 of the loop, so that a ragged edge does
 * not count as a corner.  The corners of narrow strips show only at shorter reaches, so the reach
 * is divided by sqrt(2) again and again, down to one and a half edges of mean length.  The first
 * reach at which the boundary has four clear corners is used.  Corners are taken in the order of
 * their turns, largest first, each more than two reaches away from those before.  Four are clear if
 * their turns are at least 50 degrees, and that of the fifth is at most 0.6 of that of the fourth.
 * Without such a reach, the four corners are the vertices nearest to equal arc length.  In both
 * cases corner[0] is the corner nearest to the start of the loop, the vertex of lowest number in
 * it.
 *
 * Returns 1 when clear corners were found, 0 for equal arc length, or CORNERS_ENOMEM or
 * CORNERS_EFEW. */
int corners_auto(const Disk *d, int corner[4]);

/* Finds the indices of four vertices in the loop.  Returns 0, CORNERS_EINNER or CORNERS_EORDER
 * (also for clockwise order). */
int corners_given(const Disk *d, const int vertex[4], int corner[4], int *at);

/* The vertices nearest to four places of the loop, in its order.  A place is the arc
 * length from the start divided by the length of the loop, 0 <= place < 1.  If two would be the
 * same vertex, the later one becomes the next vertex.  Returns 0, CORNERS_ENOMEM or
 * CORNERS_EFEW. */
int corners_at(const Disk *d, const double place[4], int corner[4]);

/* The boundary vertex nearest to x; among equally near ones the lowest number. */
int corners_nearest(const Disk *d, const double x[3]);

#endif
