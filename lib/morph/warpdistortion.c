/* warpdistortion.c - the distortion of a map of a rectangle, and its derivatives. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "warpdistortion.h"

static const double LEAST = 1e-3;       /* J of a map that counts as folded */
static const double SIZE = 0.1;         /* weight of J + 1/J - 2 */

/* One row of cells.  Differences along u on its lower and its upper side, along v at each node;
 * all [2][nu], and the derivatives by them. */
typedef struct Row {
	double *u[2], *v, *gu[2], *gv;
} Row;

enum { ARRAYS = 12 };           /* of nu numbers in a Row */

int
warpdistortion_init(WarpDistortion *w, int nu, int nv, double T)
{
	*w = (WarpDistortion){ nu, nv, T, malloc(((size_t)ARRAYS*nu + 1)*nv*sizeof *w->work), 1, 0, 0 };
	return w->work ? 0 : WARPDISTORTION_ENOMEM;
}

void
warpdistortion_free(WarpDistortion *w)
{
	free(w->work);
	w->work = NULL;
}

double
warpdistortion_of(double mu)
{
	return 2*mu*mu/(1 - mu*mu);
}

static Row
differences(const WarpDistortion *w, const double *f, int j)
{
	int nu = w->nu, c, i, a;
	size_t n = (size_t)nu*w->nv;
	double *x = w->work + (size_t)j*ARRAYS*nu, h = nu - 1, k = (w->nv - 1)/w->T;
	Row r = { { x, x + 2*nu }, x + 4*nu, { x + 6*nu, x + 8*nu }, x + 10*nu };

	memset(r.gu[0], 0, 6*(size_t)nu*sizeof *x);
	for (c = 0; c < 2; c++) {
		const double *p = f + c*n + (size_t)j*nu, *q = p + nu;

		for (a = 0; a < 2; a++)
			for (i = 0; i < nu - 1; i++)
				r.u[a][c*nu+i] = ((a ? q : p)[i+1] - (a ? q : p)[i])*h;
		for (i = 0; i < nu; i++)
			r.v[c*nu+i] = (q[i] - p[i])*k;
	}
	return r;
}

/* The sum over the corners of one kind in a row of cells; derivatives times a are added to gu, gv.
 * u and v: the differences at the first corner.  *least: the least J. */
static double
corners(const WarpDistortion *w, double a, const double *restrict u, const double *restrict v,
	double *restrict gu, double *restrict gv, double *least)
{
	double sum = 0, low = *least;
	int nu = w->nu, m = nu - 1, i;

	for (i = 0; i < m; i++) {
		double u0 = u[i], u1 = u[nu+i], v0 = v[i], v1 = v[nu+i], J = u0*v1 - u1*v0;
		double S0 = u0*u0 + v0*v0, S1 = u1*u1 + v1*v1, per = 1/J;
		double d = (S0/w->stretch + S1*w->stretch)/2*per;
		double over = d - 1 > w->limit ? d - 1 - w->limit : 0, b = 2*w->stiff*over;
		double d0 = a*per*(1 + b/w->stretch), d1 = a*per*(1 + b*w->stretch);
		double dJ = a*(SIZE - ((S0 + S1)/2 + SIZE)*per*per - b*d*per);

		low = J < low ? J : low;
		sum += (S0 + S1)/2*per - 1 + SIZE*(J + per - 2) + w->stiff*over*over;
		gu[i] += d0*u0 + dJ*v1;
		gu[nu+i] += d1*u1 - dJ*v0;
		gv[i] += d0*v0 - dJ*u1;
		gv[nu+i] += d1*v1 + dJ*u0;
	}
	*least = low;
	return sum;
}

/* Adds the derivatives by the differences of a row to those by f, in its two rows of nodes. */
static void
spread(const WarpDistortion *w, const Row *r, int j, double *g)
{
	int nu = w->nu, c, i, a;
	size_t n = (size_t)nu*w->nv;
	double h = nu - 1, k = (w->nv - 1)/w->T;

	for (c = 0; c < 2; c++) {
		double *p = g + c*n + (size_t)j*nu, *q = p + nu;

		for (a = 0; a < 2; a++)
			for (i = 0; i < nu - 1; i++) {
				(a ? q : p)[i+1] += h*r->gu[a][c*nu+i];
				(a ? q : p)[i] -= h*r->gu[a][c*nu+i];
			}
		for (i = 0; i < nu; i++) {
			q[i] += k*r->gv[c*nu+i];
			p[i] -= k*r->gv[c*nu+i];
		}
	}
}

double
warpdistortion(const WarpDistortion *w, const double *f, double a, double *g)
{
	int nu = w->nu, rows = w->nv - 1, odd, k;
	double *sum = w->work + (size_t)ARRAYS*nu*w->nv, corner = 4.0*(nu - 1)*rows, total = 0;

	/* Even rows of cells first, then odd ones: those of one kind share no node. */
	for (odd = 0; odd < 2; odd++) {
#pragma omp parallel for schedule(static)
		for (k = 0; k < (rows + 1 - odd)/2; k++) {
			int j = 2*k + odd, s, b;
			double least = 1;
			Row r = differences(w, f, j);

			sum[j] = 0;
			for (s = 0; s < 2; s++)
				for (b = 0; b < 2; b++)
					sum[j] += corners(w, a/corner, r.u[s], r.v + b, r.gu[s], r.gv + b, &least);
			if (!(least > LEAST))
				sum[j] = INFINITY;
			else
				spread(w, &r, j, g);
		}
	}
	for (k = 0; k < rows; k++)
		total += sum[k];
	return total < INFINITY ? total/corner : INFINITY;
}

void
warpdistortion_mu(const WarpDistortion *w, const double *f, double stretch, double *mean, double *most)
{
	int nu = w->nu, nv = w->nv, i, j, c;
	size_t n = (size_t)nu*nv;
	double h = 0.5*(nu - 1), k = 0.5*(nv - 1)/w->T, u[2], v[2], mu;

	*mean = *most = 0;
	for (j = 0; j < nv - 1; j++)
		for (i = 0; i < nu - 1; i++) {
			for (c = 0; c < 2; c++) {
				const double *p = f + c*n + (size_t)j*nu + i;
				double s = c ? stretch : 1;

				u[c] = s*h*(p[1] - p[0] + p[nu+1] - p[nu]);
				v[c] = s*k*(p[nu] - p[0] + p[nu+1] - p[1]);
			}
			/* f_zbar/f_z; f_u = u0 + i u1, f_v = v0 + i v1 */
			mu = hypot(u[0] - v[1], u[1] + v[0])/fmax(hypot(u[0] + v[1], u[1] - v[0]), 1e-300);
			*mean += mu;
			*most = fmax(*most, mu);
		}
	*mean /= (nu - 1.0)*(nv - 1);
}
