/* pillowpolish.h - makes a nearly conformal grid on a pillow conformal (doc/mathematics.md 3.9).
 *
 * As in polish.h, the grid is mapped by its own metric.  Its double is a torus, on which the harmonic coordinates a and
 * b grow by 1 along u and along v (gridlaplace.h).  They are the coordinates of C/(Z + tau Z), zeta = a + tau b, with
 *
 *   tau = i B/(1 + i A),   A = -E(a,b),   B = E(a,a),
 *
 * E the Dirichlet energy of the torus.  tau is not quite imaginary, as the cross-ratio of the cones is not quite real: so zeta is mapped to
 * the sphere (../base/torusplane.h), and its cones (0,0), (1/2,0), (1/2,T) to those of a pillow of height Im tau/2.
 * These stay where they are on the surface; the fourth moves to where that pillow has it.
 */
#ifndef PILLOWPOLISH_H
#define PILLOWPOLISH_H

#include "pillowgrid.h"

/* Polishes the grid in at most `most` rounds, of which one is kept as polish.h says.  fixed: 0; or the height T that is kept, in
 * place of Im tau/2: any sphere with four points on a circle is a pillow of any height, with the fourth cone elsewhere.
 * *done: the number of the round, 0: none.  Returns 0 or POLISH_ENOMEM. */
int pillowpolish(const SphereSampler *s, PillowGrid *a, double fixed, int most, double enough, int *done);

/* The modulus tau of the gridded surface a, and where its map to the new pillow, of height `fixed` or Im tau/2, takes each node;
 * metric is of gridlaplace.h.  Returns 0 or POLISH_ENOMEM. */
int pillowpolish_map(const PillowGrid *a, int metric, double fixed, Spinor *to, double complex *tau);

#endif
