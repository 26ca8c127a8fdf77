/* blendmetric.h - conformal factor and mean curvature between several surfaces, by their metrics.
 *
 * The metric of a grid is the matrix g = lambda^2 (1+nu1, nu2; nu2, 1-nu1), with the residual channels nu
 * of lambdah.h.  Its logarithm is linear in the weights:
 *
 *   log g = m I + (p, q; q, -p),   m = log lambda^2 + log(1 - r^2)/2,   (p,q) = artanh(r) nu/r,   r = |nu|
 *   back:  lambda^2 = e^m cosh s,   nu = tanh(s) (p,q)/s,   s = |(p,q)|
 *
 * H is such that lambda H is linear in the weights.  tau follows from the metric up to truncation
 *
 *   tau1 = ((lambda^2 nu1)_u + (lambda^2 nu2)_v)/lambda^2   tau2 = ((lambda^2 nu2)_u - (lambda^2 nu1)_v)/lambda^2
 *
 * and the difference between the stored channels and these formulas is linear in the weights.
 *
 * Without residual channels log lambda and lambda^2 H are linear in the weights.  doc/mathematics.md 8.1.
 */
#ifndef BLENDMETRIC_H
#define BLENDMETRIC_H

#include "../base/chart.h"

/* The fields of one surface, each [nv][nu]; nu[0] is NULL if there are no residual channels. */
typedef struct Metric {
	Chart   g;
	double *lambda, *H, *nu[2], *tau[2];
} Metric;

/* Sets the fields of `to` from those of `count` surfaces on charts of equal kind and size; all of them
 * have residual channels, or none.  The weights sum to 1; negative ones extrapolate.  lambda > 0.  log lambda gains
 * e, [nv][nu], or nothing if e is NULL; lambda H stays.  If one weight is 1 and all others are 0, the fields are copies,
 * whatever e is. */
void blendmetric(int count, const double *w, const Metric *of, const double *e, const Metric *to);

/* tau of the metric of m at the inner node (i,j), by the formulas above, of second order in h and k. */
void blendmetric_tau(const Metric *m, int i, int j, double tau[2]);

#endif
