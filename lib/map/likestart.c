/* likestart.c - nearest points, and the Moebius map that fits them. */
#include <lapacke.h>
#include <stdlib.h>
#include <string.h>

#include "likestart.h"

enum {
	ROUNDS   = 4,           /* of nearest points and maps */
	WEIGHTED = 3            /* solutions for a map, with weights from the one before */
};

/* ---- a map from pairs of places -------------------------------------- */

/* Sets M to the least value of  sum |M Z x z|^2/|M Z|^2,  x as in moebius_cross: for given |M Z| the numbers of M are an
 * eigenvector.  Returns 0 if there is none. */
static int
fit_map(int n, Spinor *Z, Spinor *z, Moebius M)
{
	double complex H[4][4], a[4], work[64];
	double value[4], more[16], w;
	Spinor to;
	int round, i, k, l;

	M[0][0] = M[1][1] = 1, M[0][1] = M[1][0] = 0;
	for (round = 0; round < WEIGHTED; round++) {
		memset(H, 0, sizeof H);
		for (i = 0; i < n; i++) {
			for (k = 0; k < 2; k++) {
				a[k] = Z[i][k]*z[i][1];
				a[2+k] = -Z[i][k]*z[i][0];
				to[k] = M[k][0]*Z[i][0] + M[k][1]*Z[i][1];
			}
			w = round ? 1/(moebius_square(to[0]) + moebius_square(to[1])) : 1;
			for (k = 0; k < 4; k++)
				for (l = 0; l < 4; l++)
					H[l][k] += w*conj(a[k])*a[l];   /* by columns */
		}
		for (k = 0; k < 16; k++)
			if (!isfinite(creal(H[k/4][k%4])) || !isfinite(cimag(H[k/4][k%4])))
				return 0;
		if (LAPACKE_zheev_work(LAPACK_COL_MAJOR, 'V', 'U', 4, &H[0][0], 4, value, work, 64, more))
			return 0;
		memcpy(M, H[0], sizeof H[0]);
	}
	return 1;
}

/* ---- a position ------------------------------------------------------ */

double
likestart_motion(const LikeGrid *a, const LikePoints *b, Moebius M, double *to, Rigid *r)
{
	double rms;
	int i, k;

	for (k = 0; k < 4; k++)
		if (!isfinite(creal(M[k/2][k%2])) || !isfinite(cimag(M[k/2][k%2])))
			return HUGE_VAL;
	#pragma omp parallel for schedule(static)
	for (i = 0; i < b->n; i++) {
		Spinor w;

		moebius_apply(M, b->Z[i], w);
		likegrid_point(a, w, &to[3*i]);
	}
	return procrustes(b->n, NULL, to, b->x, r, &rms) ? HUGE_VAL : rms;
}

/* z: the places of the points of a nearest to those of b, moved by r. */
static void
nearest(const LikePoints *a, const LikePoints *b, const Rigid *r, Spinor *z)
{
	int i;

	#pragma omp parallel for schedule(static)
	for (i = 0; i < b->n; i++) {
		double x[3], least = HUGE_VAL, d2;
		int k, best = 0;

		memcpy(x, &b->x[3*i], sizeof x);
		rigid_move(r, 1, x);
		for (k = 0; k < a->n; k++) {
			const double *y = &a->x[3*k];

			d2 = (x[0] - y[0])*(x[0] - y[0]) + (x[1] - y[1])*(x[1] - y[1]) + (x[2] - y[2])*(x[2] - y[2]);
			if (d2 < least) {
				least = d2;
				best = k;
			}
		}
		memcpy(z[i], a->Z[best], sizeof z[i]);
	}
}

static void
improve(const LikeGrid *a, const LikePoints *b, Spinor *z, double *to, LikeStart *s)
{
	LikeStart next = *s;
	Moebius one = { { 1, 0 }, { 0, 1 } };
	int round;

	s->rms = HUGE_VAL;
	for (round = 0; round < ROUNDS; round++) {
		nearest(&a->points, b, &next.r, z);
		if (!fit_map(b->n, b->Z, z, next.M))
			return;
		moebius_multiply(one, next.M, next.M);
		next.rms = likestart_motion(a, b, next.M, to, &next.r);
		if (!(next.rms < s->rms))
			return;
		*s = next;
	}
}

/* ---- all positions --------------------------------------------------- */

/* The rotation number k = 0 .. 23 of a cube: axis i goes to `sign` times axis to[i]. */
static void
turn_of_cube(int k, int to[3], double sign[3])
{
	static const int order[6][3] = { { 0, 1, 2 }, { 1, 2, 0 }, { 2, 0, 1 }, { 0, 2, 1 }, { 2, 1, 0 }, { 1, 0, 2 } };

	memcpy(to, order[k/4], 3*sizeof *to);
	sign[0] = k & 1 ? -1 : 1;
	sign[1] = k & 2 ? -1 : 1;
	sign[2] = sign[0]*sign[1]*(k/4 < 3 ? 1 : -1);
}

static void
place(const LikePoints *a, const LikePoints *b, int k, Rigid *r)
{
	double sign[3];
	int to[3], i, m, n;

	memset(r, 0, sizeof *r);
	for (i = 0; i < 3 && k < 0; i++)
		r->R[i][i] = 1;
	if (k < 0)
		return;
	turn_of_cube(k, to, sign);
	for (i = 0; i < 3; i++)
		for (m = 0; m < 3; m++)
			for (n = 0; n < 3; n++)
				r->R[m][n] += sign[i]*a->axis[to[i]][m]*b->axis[i][n];
}

static int
by_rms(const void *x, const void *y)
{
	const LikeStart *a = x, *b = y;

	return (a->rms > b->rms) - (a->rms < b->rms);
}

int
likestart(const LikeGrid *a, const LikePoints *b, LikeStart s[LIKESTART_COUNT])
{
	Spinor *z = malloc(b->n*sizeof *z);
	double *to = malloc(3*b->n*sizeof *to);
	int k, e = z && to ? 0 : LIKEPOINTS_ENOMEM;

	for (k = 0; !e && k < LIKESTART_COUNT; k++) {
		place(&a->points, b, k - 1, &s[k].r);
		improve(a, b, z, to, &s[k]);
	}
	if (!e)
		qsort(s, LIKESTART_COUNT, sizeof *s, by_rms);
	free(z);
	free(to);
	return e;
}
