/* procrustes.h - the rigid motion that brings points nearest to their counterparts
 * (W. Kabsch 1976; S. Umeyama 1991). */
#ifndef PROCRUSTES_H
#define PROCRUSTES_H

enum {
	PROCRUSTES_EVALUE = -1,         /* not finite, or too large to be squared */
	PROCRUSTES_ESVD   = -2          /* LAPACK's singular values did not converge */
};

/* x -> R x + t, R a rotation: det R = 1, no reflection. */
typedef struct Rigid {
	double R[3][3], t[3];
} Rigid;

/* The rotation that maximises  sum <a, R b> = tr(R' C)  for  C = sum a b',  and the maximum:
 * R = U diag(1, 1, det UV') V' and s1 + s2 +- s3, from the decomposition C = U s V'.  If several
 * rotations do (points on one line), it is one of them; the identity if C = 0.
 *
 * Returns 0, PROCRUSTES_EVALUE or PROCRUSTES_ESVD. */
int procrustes_rotation(double C[3][3], double R[3][3], double *gain);

/* The motion r of b that minimises  sum w |a - (R b + t)|^2.
 *
 * w     in   [n] >= 0, one of them positive; NULL: all equal
 * a, b  in   [n][3]
 * rms   out  square root of that minimum over sum w
 *
 * Returns as procrustes_rotation. */
int procrustes(int n, const double *w, const double *a, const double *b, Rigid *r, double *rms);

/* x moved, n points [n][3]. */
void rigid_move(const Rigid *r, int n, double *x);

/* The angle of the rotation, 0 .. pi. */
double rigid_angle(const Rigid *r);

#endif
