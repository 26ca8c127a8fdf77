/* curvematch.h - where one closed curve begins when another does. */
#ifndef CURVEMATCH_H
#define CURVEMATCH_H

enum {
	CURVEMATCH_ENOMEM = -1,
	CURVEMATCH_EVALUE = -2          /* a curve that is not finite */
};

/* For every shift s the distance of the curve a from the curve b that begins s points later,
 * moved rigidly as near as can be:
 *
 *   rms[s]^2 = min over R, t of the mean of |a_i - (R b_(i+s mod n) + t)|^2
 *            = (|a|^2 + |b|^2 - 2 max over R of tr(R' C(s)))/n,   C(s) = sum a_i b'_(i+s)
 *
 * of centred curves: nine cross-correlations by Fourier transforms and n small
 * singular value problems (procrustes.h).  rms is 0 below 3e-7 of the size of the
 * curves, which is what rounding leaves.
 *
 * a, b   in   [n][3]
 * rms    out  [n]
 * angle  out  [n] of the rotation R, 0 .. pi
 *
 * Returns 0, CURVEMATCH_ENOMEM or CURVEMATCH_EVALUE. */
int curvematch(int n, const double *a, const double *b, double *rms, double *angle);

/* The shift of the least rms; where several local minima are within a factor of clear >= 1 of
 * it, the one of them that turns b least: outlines of faces, to take an example, fit upside down
 * nearly as well, and most files have faces upright. */
int curvematch_choose(int n, const double *rms, const double *angle, double clear);

/* The least of the local minima that are an eighth of the curve or more away from shift,
 * HUGE_VAL where there is none. */
double curvematch_next(int n, const double *rms, int shift);

#endif
