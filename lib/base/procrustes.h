/* procrustes.h - the rigid motion that brings points nearest to their counterparts
 * (W. Kabsch 1976; S. Umeyama 1991). */
#ifndef PROCRUSTES_H
#define PROCRUSTES_H

enum {
	PROCRUSTES_EVALUE = -1,         /* a number is not finite, or a sum of them overflows */
	PROCRUSTES_ESVD   = -2          /* the singular value decomposition did not converge */
};

/* x -> R x + t, R a rotation: det R = 1, no reflection. */
typedef struct Rigid {
	double R[3][3], t[3];
} Rigid;

/* The rotation R that maximises  sum <a, R b> = tr(R' C)  for  C = sum a b';  gain is the maximum.
 * Both follow from the singular value decomposition C = U s V':  R = U diag(1, 1, d) V' and
 * gain = s1 + s2 + d s3,  with d = 1 or -1 such that det R = 1.  If several rotations reach the
 * maximum (points on one line), R is one of them.  If C = 0, R is the identity.
 *
 * Returns 0, PROCRUSTES_EVALUE or PROCRUSTES_ESVD. */
int procrustes_rotation(double C[3][3], double R[3][3], double *gain);

/* The rigid motion r = (R, t) that, applied to b, minimises  sum w |a - (R b + t)|^2.
 *
 * w     in   [n] >= 0, at least one positive; NULL: all equal
 * a, b  in   [n][3]
 * rms   out  root mean square of the distances: sqrt(minimum / sum w)
 *
 * Returns as procrustes_rotation. */
int procrustes(int n, const double *w, const double *a, const double *b, Rigid *r, double *rms);

/* Moves the n points x, [n][3], in place. */
void rigid_move(const Rigid *r, int n, double *x);

/* The angle of the rotation R, 0 .. pi radians. */
double rigid_angle(const Rigid *r);

#endif
