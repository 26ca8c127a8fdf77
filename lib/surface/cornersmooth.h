/* cornersmooth.h - smooths the corners of a fitted surface, where its cells may fold.
 *
 * Where the boundary of the mesh is smooth at a corner of the rectangle, lambda goes to 0 there, and
 * with it all residuals: folded cells cost nothing.  What holds there is that phi is about harmonic,
 * like z^2 at a corner whose angle is doubled.  So phi gains the field d,
 *
 *   Delta d = -(1 - x) Delta phi,      d = 0 on the border,
 *
 * 1 - x being corner_share (corner.h).  Delta phi then goes to 0 at the corner, and d, which is harmonic
 * elsewhere, leaves no seam.  With a place, phi first becomes the place there.
 * doc/mathematics.md 6.9. */
#ifndef CORNERSMOOTH_H
#define CORNERSMOOTH_H

#include "misfit.h"

enum { CORNERSMOOTH_ENOMEM = -1 };

/* Smooths the corners where a cell is folded, or, without a place, where the weight o at the innermost
 * node is less than 1/2.  A corner that would keep all its folded cells stays as it is: there the grid
 * is too coarse for the surface.  Returns 0 or CORNERSMOOTH_ENOMEM. */
int corners_smooth(const Misfit *m, double *phi);

#endif
