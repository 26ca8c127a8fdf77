/* pillowplane.h - the Riemann sphere on the pillow (chart.h), by elliptic functions.
 *
 *   z = s sn(K (4u-1) + i K' v/T, k),   k = s^2,   4 T = K'/K,
 *
 * maps the pillow conformally onto the sphere: the cones (0,0), (1/2,0), (0,T), (1/2,T) to -s, s, -1/s, 1/s.
 * z is even under the turns by pi about the cones.  The half v <= T/2 is the sock of height T/2
 * (sockplane.h), which goes to the disk |z| <= 1; the other half is its mirror image:
 *
 *   z(u,T-v) = 1/conj z(u,v).
 *
 * Seen from outside, with (u,v) turning anticlockwise, the sphere is the stereographic image
 *
 *   (2 Re z, 2 Im z, 1 - |z|^2)/(1 + |z|^2),
 *
 * whose point z = 0 is the north pole.  A point is given in homogeneous coordinates Z[0] : Z[1], z = Z[0]/Z[1], of
 * which the larger is of modulus 1.  doc/mathematics.md 3.9.
 */
#ifndef PILLOWPLANE_H
#define PILLOWPLANE_H

#include "sockplane.h"

typedef struct PillowPlane {
	double    T;
	SockPlane half;         /* the sock of height T/2 */
} PillowPlane;

/* The pillow of height T, 2e-3 <= T <= 100. */
PillowPlane pillowplane(double T);

/* The point at (u,v), 0 <= v <= T; and (u,v) at a point, with 0 <= u < 1, 0 <= v <= T.  Only the ratio of Z
 * matters to pillowplane_uv.  Errors: a few units of rounding, away from the cones of (u,v). */
void pillowplane_z(const PillowPlane *p, double u, double v, double complex Z[2]);
void pillowplane_uv(const PillowPlane *p, const double complex Z[2], double *u, double *v);

/* The conformal factor of the round sphere of radius 1; 0 at the cones. */
double pillowplane_round(const PillowPlane *p, double u, double v);

#endif
