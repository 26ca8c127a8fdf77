/* loop.h - the boundary loops of a sheet.  Private to lib/mend. */
#ifndef LOOP_H
#define LOOP_H

#include "sheet.h"

typedef struct Loop {
	int    side;            /* its side that starts at its lowest vertex */
	int    n;               /* vertices */
	double length;
} Loop;

/* Sets *loop to an array of all loops, in the order of their lowest vertices, to be freed.  Needs twins,
 * neighbours that agree in orientation, and a vertex for each fan.  Returns the number of loops, or
 * MESH_ENOMEM. */
int loop_find(const Sheet *s, Loop **loop);

/* The loop of a boundary side. */
Loop loop_at(const Sheet *s, int side);

/* The boundary side that follows a boundary side round the surface: the next one at its end. */
int loop_next(const Sheet *s, int side);

#endif
