/* find.h - the map of lhwarp: which quarter turn, and the map itself. */
#ifndef CMD_FIND_H
#define CMD_FIND_H

#include "../../lib/morph/warp.h"
#include "marks.h"

typedef struct Found {
	int     turns;          /* quarter turns of B's chart (warpturn.h) */
	Warp    warp;
	double  stretch;        /* height of B's chart, turned, over that of A's */
	WarpFit before, after;  /* f = id, and the map */
} Found;

typedef struct FindOptions {
	int    normals, force;
	double mumax;
} FindOptions;

/* Finds the map; marks may be NULL.  Dies if no quarter turn is clearly better than the others, unless
 * landmarks are given or o->force is set, and if |mu| cannot be kept below o->mumax. */
void find_map(const Side *a, const Side *b, const Marks *marks, const FindOptions *o, Found *f);

#endif
