/* conesearch.h - moves the four cones of a pillow to the least chi^2 near them. */
#ifndef CONESEARCH_H
#define CONESEARCH_H

#include "conemap.h"
#include "sphereparts.h"

/* The first three cones are at P, and the last is on the circle through them, which is real on the sphere of the
 * pillow.  So a change of T moves the last one alone.  Where limbs are long, the others stay at their tips only in
 * this way: any other motion leads out of these within a tiny fraction of the sphere. */
typedef struct ConeSearch {
	const SphereParts *p;
	int                fixed;       /* 1: T is free; 0: P, too */
	Spinor             P[3];
	double             T;           /* 1/(4T) is the same pillow with u and v exchanged */
} ConeSearch;

/* Sets T to the best of some heights.  Returns 0 if there is none, as two of P are equal. */
int conesearch_scan(ConeSearch *s);

/* Moves the cones to lower log chi^2, and returns it. */
double conesearch_descend(ConeSearch *s);

#endif
