/* harmonicshare.h - makes a share of a surface harmonic. */
#ifndef HARMONICSHARE_H
#define HARMONICSHARE_H

#include "../base/chart.h"

enum { HARMONICSHARE_ENOMEM = -1 };

/* to = phi + d, [3][nv][nu], where, with x = share, [nv][nu],
 *
 *   Delta d = -x Delta phi,      d = 0 on the border.
 *
 * Delta to is 0 where x is 1, and d is harmonic where x is 0, so there is no seam.  x counts at inner nodes only.
 * Returns 0 or HARMONICSHARE_ENOMEM. */
int harmonic_share(Chart g, const double *share, const double *phi, double *to);

#endif
