/* polyfit.h - one cubic polynomial through a vertex, by weighted least squares over the
 * vertices around it.  Private to lib/; gradient.h states the minimised sum.
 */
#ifndef POLYFIT_H
#define POLYFIT_H

#include "gradient.h"

enum {
	POLYFIT_MOST  = 64,     /* points of a neighbourhood, its centre included */
	POLYFIT_TERMS = 9,      /* x y  xx xy yy  xxx xxy xyy yyy */
	POLYFIT_COLS  = POLYFIT_TERMS + 3
};

/* Vertices around v[0], ring after ring; the outermost ring begins at v[ring].  slot is a hash table
 * that finds a vertex in v: its entries are 1 more than indices of v, or 0 if empty. */
typedef struct Hood {
	int           n, ring;
	int           full;     /* 1 if a vertex had no room */
	int           v[POLYFIT_MOST];
	unsigned char slot[2*POLYFIT_MOST];
} Hood;

/* The matrix of the least squares problem, made triangular: columns of weighted monomials, then the
 * three right-hand sides, weighted differences of phi. */
typedef struct Polyfit {
	int    rows, rank;
	int    term[POLYFIT_TERMS];     /* [rank] for each row of the triangle its first column,
	                                 * which is also the number of a term; ascending */
	double to[2][2];                /* (x,y) = to (du,dv) */
	double a[POLYFIT_MOST][POLYFIT_COLS];
} Polyfit;

/* Computes the fit.  f->rank is the number of terms: 9, or less if there are too few points or some
 * terms are linearly dependent on earlier ones at these points. */
void polyfit(Polyfit *f, const Hood *h, const Mesh *m, const double *u, const double *v);

/* The derivatives at v[0] of the fit with the terms up to the given degree, 1 to 3. */
void polyfit_jet(const Polyfit *f, int degree, Jet *jet);

#endif
