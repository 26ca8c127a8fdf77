/* torusplane.h - the sphere as a torus of complex modulus over its turns by pi.
 *
 * The torus C/(Z + tau Z) is the double of a pillow whose two sheets are sheared: tau = 2 i T for the pillow of height T
 * (pillowplane.h).  By theta functions of the nome q = exp(2 pi i tau),
 *
 *   z = theta1(x)/theta4(x),   x = 2 pi (zeta - 1/4),
 *
 * is even under zeta -> -zeta, and maps 0, 1/2, tau/2, 1/2 + tau/2 to -s, s, -1/s, 1/s, s = theta2(0)/theta3(0).
 * M. Abramowitz, I. Stegun, Handbook of Mathematical Functions, 16.27, 16.36.
 */
#ifndef TORUSPLANE_H
#define TORUSPLANE_H

#include "cmplx.h"

/* The largest modulus of the nome: T = .01 on a pillow. */
#define TORUSPLANE_LEAST 0.02           /* least imaginary part of tau */

/* The point Z[0] : Z[1] at zeta = u + tau v. */
void torusplane_z(double complex tau, double u, double v, double complex Z[2]);

/* s. */
double complex torusplane_cone(double complex tau);

#endif
