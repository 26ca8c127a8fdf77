/* sockplane.h - the unit disk on the sock (chart.h), by elliptic functions.
 *
 *   z = s sn(K (4u-1) + i K' v/(2T), k) = theta1(x)/theta4(x),   k = s^2,   8 T = K'/K,
 *   x = 2 pi (u - 1/4 + i v),   nome exp(-8 pi T),
 *
 * maps the sock conformally onto the unit disk |z| <= 1: the cones (0,0) and (1/2,0) to -s and s, the
 * boundary v = T to the circle.  z is even under the turns of sheet.h, so it is regular at the cones.
 * Any two points a, b of the disk become the cones after a Moebius map of the disk; only their
 * hyperbolic distance enters:
 *
 *   rho = |a-b|/|1-conj(a) b|,   T = agm(1, sqrt(1-rho^2))/(4 agm(1, rho)),   s = rho/(1+sqrt(1-rho^2)).
 *
 * doc/mathematics.md 3.8; M. Abramowitz, I. Stegun, Handbook of Mathematical Functions, 16, 17;
 * B. C. Carlson, Numerical Algorithms 10 (1995) 13.
 */
#ifndef SOCKPLANE_H
#define SOCKPLANE_H

#include "cmplx.h"

typedef struct SockPlane {
	double T, s;
	double K;               /* the complete elliptic integral; K' = 8 T K */
	double L, factor;       /* the logarithm of the nome in use, and a factor of dz/du */
} SockPlane;

/* The height T of cones at distance rho, 0 < rho < 1, and the sock of height T >= 1e-3. */
double    sockplane_height(double rho);
SockPlane sockplane(double T);

/* z at (u,v), |v| <= T, and (u,v) at z, |z| <= 1, with 0 <= u < 1, 0 <= v <= T.  Errors: a few units
 * of rounding of z and, away from the cones, of (u,v). */
double complex sockplane_z(const SockPlane *p, double u, double v);
void           sockplane_uv(const SockPlane *p, double complex z, double *u, double *v);

/* |dz/du| = |dz/dv|; and the conformal factor of the round hemisphere of radius 1, 2 |dz/du|/(1+|z|^2).
 * Both are 0 at the cones. */
double sockplane_stretch(const SockPlane *p, double u, double v);
double sockplane_round(const SockPlane *p, double u, double v);

#endif
