/* relief.h - removes what is lower than a height and keeps what is higher sharp (doc/mathematics.md
 * 5.6). */
#ifndef RELIEF_H
#define RELIEF_H

#include "lowpass.h"

enum { RELIEF_ENOMEM = -1 };

/* The details of the surface between the scales s 2^j and s 2^(j+1), j = 0 .. 4, are multiplied by
 *
 *   g_j = max(0, 1 - (tau/e_j)^2),
 *
 * e_j being their height around the node: the root mean square, over about s 2^j, of the distance
 * between the positions at the two scales.
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
