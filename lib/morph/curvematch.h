/* curvematch.h - the starting point on a closed curve that corresponds to that of another. */
#ifndef CURVEMATCH_H
#define CURVEMATCH_H

enum {
	CURVEMATCH_ENOMEM = -1,
	CURVEMATCH_EVALUE = -2          /* a curve that is not finite */
};

/* For every shift s: the distance between curve a and curve b, whose starting point is moved s points
 * on, after the best rigid motion of b:
 *
 *   rms[s]^2 = min over R, t of the mean of |a_i - (R b_(i+s mod n) + t)|^2
 *            = (|a|^2 + |b|^2 - 2 max over R of tr(R' C(s)))/n,   C(s) = sum a_i b'_(i+s)
 *
 * for centred curves: nine cross-correlations by Fourier transforms and n small singular value
 * problems (procrustes.h).  Below 3e-7 of the size of the curves, the rounding error, rms is
 * set to 0.
 *
 * a, b   in   [n][3]
 * rms    out  [n]
 * angle  out  [n] of the rotation R, 0 .. pi
 *
 * Returns 0, CURVEMATCH_ENOMEM or CURVEMATCH_EVALUE. */
int curvematch(int n, const double *a, const double *b, double *rms, double *angle);

/* The shift with the smallest rms.  If several local minima are within a factor clear >= 1 of it, the
 * one with the smallest rotation of b: the outline of a face, for example, fits nearly as well upside
 * down, and in most files faces are upright. */
int curvematch_choose(int n, const double *rms, const double *angle, double clear);

/* The smallest local minimum of rms at least an eighth of the curve away from shift; HUGE_VAL if
 * there is none. */
double curvematch_next(int n, const double *rms, int shift);

#endif
