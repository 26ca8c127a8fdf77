/* relief.h - removes details lower than a given height, and keeps higher ones sharp
 * (doc/mathematics.md 5.6). */
#ifndef RELIEF_H
#define RELIEF_H

#include "lowpass.h"

enum { RELIEF_ENOMEM = -1 };

/* Let x_0 be the given fields, and x_(j+1) the given fields filtered at the scale s 2^j, j = 0 .. 4.
 * The details x_j - x_(j+1) are multiplied by
 *
 *   g_j = max(0, 1 - (tau/e_j)^2),
 *
 * where e_j is their height around the node: the root mean square, over a distance of about s 2^j, of
 * |x_j - x_(j+1)| of the place.  x_5 is kept.
 *
 * free_sides  a filter with free sides, for H
 * held        one with held sides, for x, y, z of the place less their border parts
 * s           the finest scale, a length > 0
 * tau         a length > 0
 * H, place    in/out
 *
 * Returns 0 or RELIEF_ENOMEM. */
int relief(Lowpass *free_sides, Lowpass *held, double s, double tau, double *H, double *const place[3]);

#endif
