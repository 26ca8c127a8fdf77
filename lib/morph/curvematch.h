/* curvematch.h - which point of one closed curve corresponds to the starting point of another. */
#ifndef CURVEMATCH_H
#define CURVEMATCH_H

enum {
	CURVEMATCH_ENOMEM = -1,
	CURVEMATCH_EVALUE = -2          /* a coordinate is not finite */
};

/* The distance between curve a and curve b for every shift s of the starting point of b, after the
 * best rigid motion of b:
 *
 *   rms[s]^2 = min over R, t of the mean of |a_i - (R b_(i+s mod n) + t)|^2
 *            = (|a|^2 + |b|^2 - 2 max over R of tr(R' C(s)))/n,   C(s) = sum a_i b'_(i+s)
 *
 * where the last formula is for curves whose centroid is 0.  It takes nine cross-correlations, by
 * Fourier transforms, and n singular value decompositions of 3 x 3 matrices (procrustes.h).  An rms
 * below 3e-7 of the size of the curves, the level of rounding errors, is set to 0.
 *
 * a, b   in   [n][3]
 * rms    out  [n]
 * angle  out  [n] angle of the rotation R, 0 .. pi
 *
 * Returns 0, CURVEMATCH_ENOMEM or CURVEMATCH_EVALUE. */
int curvematch(int n, const double *a, const double *b, double *rms, double *angle);

/* Returns the shift with the smallest rms, unless there are other local minima of rms that are at
 * most `clear` >= 1 times as large: among all these shifts it returns the one with the smallest
 * angle.  For example, the outline of a human face fits nearly as well upside down, but in most
 * files heads are upright. */
int curvematch_choose(int n, const double *rms, const double *angle, double clear);

/* The smallest local minimum of rms among shifts that differ from `shift` by at least n/8; HUGE_VAL
 * if there is none. */
double curvematch_next(int n, const double *rms, int shift);

#endif
