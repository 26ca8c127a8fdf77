/* moebius.h - points of the Riemann sphere as pairs of numbers, and Moebius maps as matrices.
 *
 * A point z is Z[0] : Z[1], z = Z[0]/Z[1], and a map is w = M Z.  Only ratios matter.
 */
#ifndef MOEBIUS_H
#define MOEBIUS_H

#include <math.h>

#include "cmplx.h"

typedef double complex Spinor[2];
typedef double complex Moebius[2][2];

static inline double
moebius_square(double complex x)
{
	return creal(x)*creal(x) + cimag(x)*cimag(x);
}

/* Of points of norm 1, the modulus is half their distance on the unit sphere. */
static inline double complex
moebius_cross(const Spinor a, const Spinor b)
{
	return a[0]*b[1] - a[1]*b[0];
}

/* Scales Z to the norm 1. */
static inline void
moebius_normalise(Spinor Z)
{
	double norm = sqrt(moebius_square(Z[0]) + moebius_square(Z[1]));

	Z[0] /= norm;
	Z[1] /= norm;
}

/* The point at z of the plane in which a is at 0; a is of norm 1. */
static inline void
moebius_point(const Spinor a, double complex z, Spinor b)
{
	double complex x = a[0] + z*conj(a[1]), y = a[1] - z*conj(a[0]);

	b[0] = x, b[1] = y;
	moebius_normalise(b);
}

/* The place of b in the plane in which a is at 0. */
static inline double complex
moebius_seen_from(const Spinor a, const Spinor b)
{
	return (b[0]*a[1] - b[1]*a[0])/(b[0]*conj(a[0]) + b[1]*conj(a[1]));
}

/* w = M Z and Z = M^-1 w, scaled to the norm 1. */
void moebius_apply(Moebius M, const Spinor Z, Spinor w);
void moebius_back(Moebius M, const Spinor w, Spinor Z);

/* C = A B, scaled to the determinant 1.  C may be A or B. */
void moebius_multiply(Moebius A, Moebius B, Moebius C);

/* The map that takes P[0], P[1], P[2] to W[0], W[1], W[2]. */
void moebius_three(Spinor P[3], Spinor W[3], Moebius M);

#endif
