/* flat.h - removes faces without area from a sheet.  Private to lib/mend. */
#ifndef FLAT_H
#define FLAT_H

#include "sheet.h"

/* A face is flat if its height over its longest edge is at most this share of that edge: the square root
 * of the precision of a double.  Half of the digits of its normal are then noise. */
#define FLAT_SHAPE 1.5e-8

typedef struct Flattened {
	int collapsed;          /* edges as short as that, of which the ends became one vertex */
	int edge[2];            /* the first of them of which both ends are vertices of the soup, by their
	                         * numbers there; else -1 */
	int flipped;            /* longest edges that were replaced by the other diagonal */
	int dropped;            /* faces whose longest edge is on the boundary */
	int left, at;           /* faces that could not be mended, and a vertex of the first; else -1 */
} Flattened;

/* Removes the flat faces.  The remaining vertices keep their positions.  Needs twins, and neighbours
 * that agree in orientation.  Returns 0 or MESH_ENOMEM. */
int flat_mend(Sheet *s, Flattened *r);

/* The number of flat faces. */
int flat_count(const Sheet *s);

#endif
