/* procrustes.c - the best rigid motion, by the singular values of a 3 x 3 matrix. */
#include <lapacke.h>
#include <math.h>
#include <string.h>

#include "procrustes.h"
#include "vec3.h"

static double
det3(double M[3][3])
{
	double c[3];

	cross3(M[0], M[1], c);
	return dot3(c, M[2]);
}

/* R = U diag(1, 1, d) V'.  LAPACK stores matrices by columns, so it reads C as C' = V s U'.
 * Its u therefore holds V by columns, and its vt holds U by rows. */
static void
compose(const double *u, const double *vt, double d, double R[3][3])
{
	int i, j;

	for (i = 0; i < 3; i++)
		for (j = 0; j < 3; j++)
			R[i][j] = vt[3*i]*u[j] + vt[3*i+1]*u[3+j] + d*vt[3*i+2]*u[6+j];
}

int
procrustes_rotation(double C[3][3], double R[3][3], double *gain)
{
	double c[9], s[3], u[9], vt[9], work[64], scale = 0;
	int k;

	memcpy(c, C, sizeof c);
	for (k = 0; k < 9; k++) {
		if (!isfinite(c[k]))
			return PROCRUSTES_EVALUE;
		scale = fmax(scale, fabs(c[k]));
	}
	*gain = 0;
	for (k = 0; k < 9; k++)
		R[k/3][k%3] = k%4 == 0;
	if (scale == 0)
		return 0;
	for (k = 0; k < 9; k++)
		c[k] /= scale;
	if (LAPACKE_dgesvd_work(LAPACK_COL_MAJOR, 'A', 'A', 3, 3, c, 3, s, u, 3, vt, 3, work, 64))
		return PROCRUSTES_ESVD;
	compose(u, vt, 1, R);
	if (det3(R) < 0) {
		compose(u, vt, -1, R);
		s[2] = -s[2];
	}
	*gain = scale*(s[0] + s[1] + s[2]);
	return 0;
}

/* The weighted centre of x, and the largest distance from it along a coordinate axis. */
static void
centre_and_reach(int n, const double *w, const double *x, double centre[3], double *reach)
{
	double sum = 0;
	int i, c;

	memset(centre, 0, 3*sizeof *centre);
	*reach = 0;
	for (i = 0; i < n; i++) {
		sum += w ? w[i] : 1;
		for (c = 0; c < 3; c++)
			centre[c] += (w ? w[i] : 1)*x[3*i+c];
	}
	for (c = 0; c < 3; c++)
		centre[c] /= sum;
	for (i = 0; i < 3*n; i++)
		*reach = fmax(*reach, fabs(x[i] - centre[i%3]));
}

/* C = sum w (a - ma) (b - mb)', with a measured in units of ua and b in units of ub. */
static void
covariance(int n, const double *w, const double *a, const double ma[3], double ua, const double *b,
	const double mb[3], double ub, double C[3][3])
{
	double f;
	int i, k, l;

	memset(C, 0, 9*sizeof(double));
	for (i = 0; i < n; i++)
		for (k = 0; k < 3; k++) {
			f = (w ? w[i] : 1)*(a[3*i+k] - ma[k])/ua;
			for (l = 0; l < 3; l++)
				C[k][l] += f*((b[3*i+l] - mb[l])/ub);
		}
}

/* The weighted root mean square of the distances |a - r b|.  They are squared in the given unit
 * of length, so that squares do not overflow. */
static double
rms_distance(int n, const double *w, const double *a, const double *b, const Rigid *r, double unit)
{
	double sum = 0, total = 0, x[3], d[3];
	int i;

	for (i = 0; i < n; i++) {
		memcpy(x, b + 3*i, sizeof x);
		rigid_move(r, 1, x);
		sub3(a + 3*i, x, d);
		sum += (w ? w[i] : 1)*(d[0]/unit*(d[0]/unit) + d[1]/unit*(d[1]/unit) + d[2]/unit*(d[2]/unit));
		total += w ? w[i] : 1;
	}
	return unit*sqrt(sum/total);
}

int
procrustes(int n, const double *w, const double *a, const double *b, Rigid *r, double *rms)
{
	double ma[3], mb[3], ua, ub, C[3][3], gain;
	int e, c;

	centre_and_reach(n, w, a, ma, &ua);
	centre_and_reach(n, w, b, mb, &ub);
	if (!isfinite(ua + ub))
		return PROCRUSTES_EVALUE;
	covariance(n, w, a, ma, ua > 0 ? ua : 1, b, mb, ub > 0 ? ub : 1, C);
	if ((e = procrustes_rotation(C, r->R, &gain)))
		return e;
	for (c = 0; c < 3; c++)
		r->t[c] = ma[c] - dot3(r->R[c], mb);
	*rms = rms_distance(n, w, a, b, r, ua + ub > 0 ? ua + ub : 1);
	return 0;
}

void
rigid_move(const Rigid *r, int n, double *x)
{
	double y[3];
	int i, c;

	for (i = 0; i < n; i++) {
		memcpy(y, x + 3*i, sizeof y);
		for (c = 0; c < 3; c++)
			x[3*i+c] = dot3(r->R[c], y) + r->t[c];
	}
}

double
rigid_angle(const Rigid *r)
{
	double a[3] = { r->R[2][1] - r->R[1][2], r->R[0][2] - r->R[2][0], r->R[1][0] - r->R[0][1] };

	return atan2(norm3(a), r->R[0][0] + r->R[1][1] + r->R[2][2] - 1);
}
