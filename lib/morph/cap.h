/* cap.h - lowers lambda where lambda and H ask for a Gauss curvature K > H^2, which no surface has.
 *
 * K - H^2 = -((k1 - k2)/2)^2 <= 0 for the principal curvatures k1, k2 of a surface.  A blend of two surfaces
 * may have K > H^2: where a dome becomes a bowl, H passes through 0 while lambda keeps the area of
 * the dome.  With a Gaussian mean G over three nodes, the excess is
 *
 *   x = max(0, -G(Delta log lambda) - (G(lambda H))^2),      0 on the outer four rings,
 *
 * which is lambda^2 (K - H^2)+ for a conformal grid (10).  x of a surface is not quite 0, because of the mean and of noise.
 * doc/mathematics.md 8.6.
 */
#ifndef CAP_H
#define CAP_H

#include "../base/chart.h"

enum { CAP_ENOMEM = -1 };

/* Sets x, [nv][nu], to the excess of lambda and H.  Returns 0 or CAP_ENOMEM. */
int cap_excess(Chart g, const double *lambda, const double *H, double *x);

/* The integral of an excess du dv over the chart: that of (K - H^2)+ over the surface, without unit.  It is
 * 4 pi for a round sphere with H = 0. */
double cap_integral(Chart g, const double *x);

/* lambda <- lambda e^(e/2) with Delta e = x >= 0, e = 0 on the border; lambda^2 H is kept.  That adds
 * -x/2 to lambda^2 K, and to lambda^2 H^2 what it has more over a smaller lambda^2.
 *
 * x         in      [nv][nu] an excess, or the part of it that is to be removed
 * lambda, H in/out  [nv][nu]
 *
 * Returns 0 or CAP_ENOMEM. */
int cap_lower(Chart g, const double *x, double *lambda, double *H);

#endif
