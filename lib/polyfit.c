/* polyfit.c - the polynomial of one neighbourhood, by Householder reflections.
 *
 * No pivoting: columns are in the order of their degree, so the leading part of the
 * triangle is the fit of lower degree and costs nothing, and of dependent terms it is the
 * higher one that goes.
 */
#include <string.h>

#include "polyfit.h"
#include "vec3.h"

/* A term is left out when less than this share of it is new. */
static const double NEW = 0.02;

/* Extents below these, as a share of the others and in (u,v), count as 0. */
static const double FLAT = 1e-10, TINY = 1e-100;

/* The map that gives the points around the first one unit variance in all directions;
 * a direction without extent becomes 0.  Sums of squares along the principal axes, the
 * axes by half angles of (a - c, 2b). */
static void
whiten(const Hood *h, const double *u, const double *v, double to[2][2])
{
	double a = 0, b = 0, c = 0, size = 0, r, cosine, sine, x, y, xx = 0, yy = 0;
	int o = h->v[0], k;

	for (k = 1; k < h->n; k++)
		size = fmax(size, fmax(fabs(u[h->v[k]] - u[o]), fabs(v[h->v[k]] - v[o])));
	memset(to, 0, 4*sizeof to[0][0]);
	if (!(size > TINY))
		return;
	for (k = 1; k < h->n; k++) {
		x = (u[h->v[k]] - u[o])/size;
		y = (v[h->v[k]] - v[o])/size;
		a += x*x, b += x*y, c += y*y;
	}
	r = sqrt((a - c)*(a - c) + 4*b*b);
	cosine = r > 0 ? sqrt(fmax(0, 1 + (a - c)/r)/2) : 1;
	sine = r > 0 ? copysign(sqrt(fmax(0, 1 - (a - c)/r)/2), b) : 0;
	for (k = 1; k < h->n; k++) {
		x = cosine*(u[h->v[k]] - u[o]) + sine*(v[h->v[k]] - v[o]);
		y = cosine*(v[h->v[k]] - v[o]) - sine*(u[h->v[k]] - u[o]);
		xx += x/size*(x/size);
		yy += y/size*(y/size);
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

/* One weighted row per neighbour; coefficients will be derivatives in (x,y). */
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
		w = 1/d;
		a[0] = w*x, a[1] = w*y;
		a[2] = w*x*x/2, a[3] = w*x*y, a[4] = w*y*y/2;
		a[5] = w*x*x*x/6, a[6] = w*x*x*y/2, a[7] = w*x*y*y/2, a[8] = w*y*y*y/6;
		for (c = 0; c < 3; c++)
			a[POLYFIT_TERMS + c] = w*(m->xyz[3*j + c] - m->xyz[3*o + c]);
		f->rows++;
	}
}

/* Sum of squares of column c from row r on. */
static double
squares(const Polyfit *f, int c, int r)
{
	double sum = 0;

	for (; r < f->rows; r++)
		sum += f->a[r][c]*f->a[r][c];
	return sum;
}

/* Reflects the rows from r on so that column c vanishes below row r; norm is its length
 * there. */
static void
reflect(Polyfit *f, int c, int r, double norm)
{
	double alpha = -copysign(norm, f->a[r][c]), y[POLYFIT_COLS], w[POLYFIT_MOST], beta;
	int k, l;

	beta = 1/(norm*(norm + fabs(f->a[r][c])));
	f->a[r][c] -= alpha;
	memset(y, 0, sizeof y);
	for (k = r; k < f->rows; k++) {
		w[k] = f->a[k][c];
		for (l = 0; l < POLYFIT_COLS; l++)
			y[l] += w[k]*f->a[k][l];
	}
	for (k = r; k < f->rows; k++)
		for (l = 0; l < POLYFIT_COLS; l++)
			f->a[k][l] -= beta*w[k]*y[l];
	f->a[r][c] = alpha;
}

static void
factor(Polyfit *f)
{
	double whole[POLYFIT_TERMS], rest;
	int c;

	for (c = 0; c < POLYFIT_TERMS; c++)
		whole[c] = squares(f, c, 0);
	for (f->rank = 0, c = 0; c < POLYFIT_TERMS; c++) {
		rest = squares(f, c, f->rank);
		if (!(rest > NEW*NEW*whole[c]))
			continue;
		reflect(f, c, f->rank, sqrt(rest));
		f->term[f->rank++] = c;
	}
}

void
polyfit(Polyfit *f, const Hood *h, const Mesh *m, const double *u, const double *v)
{
	whiten(h, u, v, f->to);
	fill(h, m, u, v, f);
	factor(f);
}

void
polyfit_jet(const Polyfit *f, int degree, Jet *jet)
{
	double p[POLYFIT_TERMS] = { 0 }, (*to)[2] = (double (*)[2])f->to;
	int rank = f->rank, terms = degree*(degree + 3)/2, c, k, l;

	while (rank > 0 && f->term[rank - 1] >= terms)
		rank--;
	for (c = 0; c < 3; c++) {
		for (k = rank - 1; k >= 0; k--) {
			p[f->term[k]] = f->a[k][POLYFIT_TERMS + c];
			for (l = k + 1; l < rank; l++)
				p[f->term[k]] -= f->a[k][f->term[l]]*p[f->term[l]];
			p[f->term[k]] /= f->a[k][f->term[k]];
		}
		jet->u[c] = p[0]*to[0][0] + p[1]*to[1][0];
		jet->v[c] = p[0]*to[0][1] + p[1]*to[1][1];
		jet->uu[c] = p[2]*to[0][0]*to[0][0] + 2*p[3]*to[0][0]*to[1][0] + p[4]*to[1][0]*to[1][0];
		jet->uv[c] = p[2]*to[0][0]*to[0][1] + p[3]*(to[0][0]*to[1][1] + to[0][1]*to[1][0])
		    + p[4]*to[1][0]*to[1][1];
		jet->vv[c] = p[2]*to[0][1]*to[0][1] + 2*p[3]*to[0][1]*to[1][1] + p[4]*to[1][1]*to[1][1];
	}
}
