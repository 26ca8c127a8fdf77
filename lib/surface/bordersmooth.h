/* bordersmooth.h - smooths a fitted surface where its cells fold near the border.
 *
 * Between two surfaces with ragged borders, lambda and H of a blend have the singular places of both, and the border is
 * that of neither: near it the best fit may crumple.  There phi gains d with
 *
 *   Delta d = -x Delta phi,      d = 0 on the border,
 *
 * x being 1 at folded cells and 0 from corner_radius cells on, or from half of that where this leaves folds: so it
 * becomes harmonic there, and remains as smooth as it was around.  doc/mathematics.md 6.9. */
#ifndef BORDERSMOOTH_H
#define BORDERSMOOTH_H

#include "../base/chart.h"

enum { BORDERSMOOTH_ENOMEM = -1 };

/* Smooths phi, [3][nv][nu], at the cells within corner_radius of an open side that are folded (fold.h), until none
 * is, or they become no fewer; then moves single nodes where a corner is still folded (cornerunfold.h).  Without
 * such cells phi keeps its bits.  Returns 0 or BORDERSMOOTH_ENOMEM. */
int border_smooth(Chart g, double *phi);

#endif
