/* mollify.h - flat triangles of an intrinsic triangulation get area (doc/mathematics.md 3.6). */
#ifndef MOLLIFY_H
#define MOLLIFY_H

#include "intrinsic.h"

/* Flat triangles have no usable angles.  So in each triangle that is flat up to rounding, lengthens the
 * shortest edge (all, if several are equally short) until any two sides together exceed the third by
 * 1e-13 of the shortest, in at most 100 rounds.  Call it before any flip.  Returns 0 or
 * INTRINSIC_ENOMEM. */
int  intrinsic_mollify(Intrinsic *t);

#endif
