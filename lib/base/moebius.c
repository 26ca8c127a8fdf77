/* moebius.c - products of 2 x 2 matrices. */
#include <string.h>

#include "moebius.h"

void
moebius_apply(Moebius M, const Spinor Z, Spinor w)
{
	double complex x = M[0][0]*Z[0] + M[0][1]*Z[1], y = M[1][0]*Z[0] + M[1][1]*Z[1];

	w[0] = x, w[1] = y;
	moebius_normalise(w);
}

void
moebius_back(Moebius M, const Spinor w, Spinor Z)
{
	double complex x = M[1][1]*w[0] - M[0][1]*w[1], y = M[0][0]*w[1] - M[1][0]*w[0];

	Z[0] = x, Z[1] = y;
	moebius_normalise(Z);
}

void
moebius_multiply(Moebius A, Moebius B, Moebius C)
{
	Moebius R;
	double complex root;
	int i, k;

	for (i = 0; i < 2; i++)
		for (k = 0; k < 2; k++)
			R[i][k] = A[i][0]*B[0][k] + A[i][1]*B[1][k];
	root = csqrt(R[0][0]*R[1][1] - R[0][1]*R[1][0]);
	for (i = 0; i < 2; i++)
		for (k = 0; k < 2; k++)
			C[i][k] = R[i][k]/root;
}

/* The map that takes 0, infinity and 1 to P[0], P[1], P[2]. */
static void
from_standard(Spinor P[3], Moebius M)
{
	double complex a = moebius_cross(P[2], P[0]), b = moebius_cross(P[1], P[2]);
	int i;

	for (i = 0; i < 2; i++) {
		M[i][0] = a*P[1][i];
		M[i][1] = b*P[0][i];
	}
}

void
moebius_three(Spinor P[3], Spinor W[3], Moebius M)
{
	Moebius from, to, inverse;

	from_standard(P, from);
	from_standard(W, to);
	inverse[0][0] = from[1][1], inverse[0][1] = -from[0][1];
	inverse[1][0] = -from[1][0], inverse[1][1] = from[0][0];
	moebius_multiply(to, inverse, M);
}
