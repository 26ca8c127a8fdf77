/* cones.h - the two cones of a sock, chosen so that its cells are as equal on the surface as they can be.
 *
 * Given a conformal map of the surface onto the unit disk, the cells of a sock have the areas
 *
 *   a ~ S/(|z - a| |z - b| |1 - conj(a) z| |1 - conj(b) z|)
 *
 * in the chart, for a part of area S in the disk.  The cones minimise parts_lost (parts.h) of about sixteen thousand
 * parts.  doc/mathematics.md 3.8.
 */
#ifndef CONES_H
#define CONES_H

#include "parts.h"

/* chi^2 of a sock with cones a, b; and of the rectangle with these corners on the unit circle. */
double parts_sock(const Parts *p, double complex a, double complex b);
double parts_rectangle(const Parts *p, const double complex corner[4]);

/* Sets cone to the best cones found from several starts, |cone| < 1, for a height of the sock of
 * CONES_LEAST at least. */
#define CONES_LEAST 0.05
void cones_choose(const Parts *p, double complex cone[2]);

#endif
