/* polyfit.c - least squares for the polynomial of a neighbourhood, by Householder reflections.
 *
 * There is no pivoting: the columns are ordered by the degree of their terms.  So the leading part
 * of the triangular factor also gives the fits of lower degree, and among linearly dependent terms
 * those of higher degree are left out.
 */
#include <string.h>

#include "../base/cpu.h"
#include "polyfit.h"
#include "../base/vec3.h"

/* A term is left out if the part of its column orthogonal to the earlier columns is shorter than
 * this fraction of the column. */
static const double NEW = 0.02;

/* The extent of the points in a direction counts as 0 if it is less than FLAT times the largest
 * extent, or less than TINY in (u,v). */
static const double FLAT = 1e-10, TINY = 1e-100;

/* A nearer point gets the weight of this distance, in units of the spread of the points.  Otherwise
 * near duplicates would decide the derivatives, and their difference quotient is mostly error: the
 * map, and so (u,v), is only known to about this share of an edge. */
static const double NEAR = 1e-3;

/* The linear map after which the points around the first one have unit variance in all
 * directions; a direction without extent is mapped to 0.  The angle of the principal axes
 * is half the angle of (a - c, 2b), where a, b, c are the entries of the covariance matrix; the
 * variances are sums of squares along the axes. */
static void
whiten(const Hood *h, const double *u, const double *v, double to[2][2])
{
	double a = 0, b = 0, c = 0, size = 0, unit, r, cosine, sine, x, y, xx = 0, yy = 0;
	int o = h->v[0], k;

	for (k = 1; k < h->n; k++)
		size = larger(size, larger(fabs(u[h->v[k]] - u[o]), fabs(v[h->v[k]] - v[o])));
	memset(to, 0, 4*sizeof to[0][0]);
	if (!(size > TINY))
		return;
	unit = 1/size;
	for (k = 1; k < h->n; k++) {
		x = (u[h->v[k]] - u[o])*unit;
		y = (v[h->v[k]] - v[o])*unit;
		a += x*x, b += x*y, c += y*y;
	}
	r = sqrt((a - c)*(a - c) + 4*b*b);
	cosine = r > 0 ? sqrt(larger(0, 1 + (a - c)/r)/2) : 1;
	sine = r > 0 ? copysign(sqrt(larger(0, 1 - (a - c)/r)/2), b) : 0;
	for (k = 1; k < h->n; k++) {
		x = cosine*(u[h->v[k]] - u[o]) + sine*(v[h->v[k]] - v[o]);
		y = cosine*(v[h->v[k]] - v[o]) - sine*(u[h->v[k]] - u[o]);
		xx += x*unit*(x*unit);
		yy += y*unit*(y*unit);
	}
	xx = size*sqrt(xx/(h->n - 1));
	yy = size*sqrt(yy/(h->n - 1));
	to[0][0] = cosine/xx;
	to[0][1] = sine/xx;
	if (yy > FLAT*xx) {
		to[1][0] = -sine/yy;
		to[1][1] = cosine/yy;
	}
}

/* Sets one weighted row for each neighbour.  The monomials are scaled so that the coefficients are
 * derivatives in (x,y). */
static void
fill(const Hood *h, const Mesh *m, const double *u, const double *v, Polyfit *f)
{
	int o = h->v[0], k, c;

	for (f->rows = 0, k = 1; k < h->n; k++) {
		int j = h->v[k];
		double du = u[j] - u[o], dv = v[j] - v[o], *a = f->a[f->rows];
		double x = f->to[0][0]*du + f->to[0][1]*dv, y = f->to[1][0]*du + f->to[1][1]*dv;
		double d = sqrt(x*x + y*y), w;

		if (!(d > FLAT))
			continue;
		w = 1/larger(d, NEAR);
		a[0] = w*x, a[1] = w*y;
		a[2] = w*x*x/2, a[3] = w*x*y, a[4] = w*y*y/2;
		a[5] = w*x*x*x/6, a[6] = w*x*x*y/2, a[7] = w*x*y*y/2, a[8] = w*y*y*y/6;
		for (c = 0; c < 3; c++)
			a[POLYFIT_TERMS + c] = w*(m->xyz[3*j + c] - m->xyz[3*o + c]);
		f->rows++;
	}
}

/* Four columns of a row at once. */
typedef double Four __attribute__((vector_size(32), aligned(8), may_alias));

/* Sum of squares of column c from row r on. */
INLINE double
squares(const Polyfit *f, int c, int r)
{
	double even = 0, odd = 0;

	for (; r + 1 < f->rows; r += 2) {
		even += f->a[r][c]*f->a[r][c];
		odd += f->a[r+1][c]*f->a[r+1][c];
	}
	return even + odd + (r < f->rows ? f->a[r][c]*f->a[r][c] : 0);
}

INLINE void
all_squares(const Polyfit *f, double whole[POLYFIT_COLS])
{
	Four *sum = (Four *)whole;
	int k, l;

	memset(whole, 0, POLYFIT_COLS*sizeof *whole);
	for (k = 0; k < f->rows; k++) {
		const Four *row = (const Four *)f->a[k];

		for (l = 0; l < POLYFIT_COLS/4; l++)
			sum[l] += row[l]*row[l];
	}
}

/* Householder reflection of the rows from r on, after which column c is 0 below row r.  norm is the
 * length of column c from row r on.  Only columns from 4*four <= c on are updated, as those before c
 * are not used below row r any more; four is a compile-time constant. */
INLINE void
reflect(Polyfit *f, int c, int r, double norm, int four)
{
	double alpha = -copysign(norm, f->a[r][c]), w[POLYFIT_MOST], beta;
	Four y[POLYFIT_COLS/4], *row;
	int k, l;

	beta = 1/(norm*(norm + fabs(f->a[r][c])));
	f->a[r][c] -= alpha;
#pragma GCC unroll 3
	for (l = four; l < POLYFIT_COLS/4; l++)
		y[l] = (Four){ 0 };
	for (k = r; k < f->rows; k++) {
		row = (Four *)f->a[k];
		w[k] = f->a[k][c];
#pragma GCC unroll 3
		for (l = four; l < POLYFIT_COLS/4; l++)
			y[l] += w[k]*row[l];
	}
	for (k = r; k < f->rows; k++) {
		row = (Four *)f->a[k];
#pragma GCC unroll 3
		for (l = four; l < POLYFIT_COLS/4; l++)
			row[l] -= beta*w[k]*y[l];
	}
	f->a[r][c] = alpha;
}

INLINE void
factor(Polyfit *f)
{
	double whole[POLYFIT_COLS], rest;
	int c;

	all_squares(f, whole);
	for (f->rank = 0, c = 0; c < POLYFIT_TERMS; c++) {
		rest = squares(f, c, f->rank);
		if (!(rest > NEW*NEW*whole[c]))
			continue;
		if (c < 4)
			reflect(f, c, f->rank, sqrt(rest), 0);
		else if (c < 8)
			reflect(f, c, f->rank, sqrt(rest), 1);
		else
			reflect(f, c, f->rank, sqrt(rest), 2);
		f->term[f->rank++] = c;
	}
}

/* factor with 256-bit vectors; the results are the same to the last bit. */
TARGET("avx2") static void
factor_256(Polyfit *f)
{
	factor(f);
}

void
polyfit(Polyfit *f, const Hood *h, const Mesh *m, const double *u, const double *v)
{
	whiten(h, u, v, f->to);
	fill(h, m, u, v, f);
	if (HAS("avx2"))
		factor_256(f);
	else
		factor(f);
}

void
polyfit_jet(const Polyfit *f, int degree, Jet *jet)
{
	double p[POLYFIT_TERMS] = { 0 }, pivot[POLYFIT_TERMS], (*to)[2] = (double (*)[2])f->to;
	int rank = f->rank, terms = degree*(degree + 3)/2, c, k, l;

	while (rank > 0 && f->term[rank - 1] >= terms)
		rank--;
	for (k = 0; k < rank; k++)
		pivot[k] = 1/f->a[k][f->term[k]];
	for (c = 0; c < 3; c++) {
		for (k = rank - 1; k >= 0; k--) {
			p[f->term[k]] = f->a[k][POLYFIT_TERMS + c];
			for (l = k + 1; l < rank; l++)
				p[f->term[k]] -= f->a[k][f->term[l]]*p[f->term[l]];
			p[f->term[k]] *= pivot[k];
		}
		jet->u[c] = p[0]*to[0][0] + p[1]*to[1][0];
		jet->v[c] = p[0]*to[0][1] + p[1]*to[1][1];
		jet->uu[c] = p[2]*to[0][0]*to[0][0] + 2*p[3]*to[0][0]*to[1][0] + p[4]*to[1][0]*to[1][0];
		jet->uv[c] = p[2]*to[0][0]*to[0][1] + p[3]*(to[0][0]*to[1][1] + to[0][1]*to[1][0])
		    + p[4]*to[1][0]*to[1][1];
		jet->vv[c] = p[2]*to[0][1]*to[0][1] + 2*p[3]*to[0][1]*to[1][1] + p[4]*to[1][1]*to[1][1];
	}
}
