/* cornersmooth.h - smooths the corners of a fitted surface, where its cells may fold.
 *
 * Where the boundary of the mesh is smooth at a corner of the rectangle, lambda and all residuals go to
 * 0 there, so folded cells cost nothing.  But near such a corner phi is nearly harmonic, like z^2, which
 * doubles the angle.  So the field d is added to phi,
 *
 *   Delta d = -x Delta phi,      d = 0 on the border,
 *
 * with x = corner_share (corner.h).  Delta (phi + d) then goes to 0 at the corner (harmonicshare.h).  Cells that are
 * still folded, between ragged borders, are turned back (cornerunfold.h).  If the misfit has a place, phi is
 * first blended into it around the corners.
 * doc/mathematics.md 6.9. */
#ifndef CORNERSMOOTH_H
#define CORNERSMOOTH_H

#include "misfit.h"

enum { CORNERSMOOTH_ENOMEM = -1 };

/* Smooths the corners where a cell is folded, or, without a place, where the weight o at the inner node
 * next to the corner is less than 1/2.  Corners where smoothing would not lower the number of folded
 * cells, or would fold some, stay as they are: there the grid is too coarse for the surface.  Returns 0
 * or CORNERSMOOTH_ENOMEM. */
int corners_smooth(const Misfit *m, double *phi);

#endif
