/* parts.h - parts of a mapped surface, and how equal the cells of a chart are on it.
 *
 * If a part has the area A on the surface and a in the chart,
 *
 *   chi^2 = sum A^2/a sum a/(sum A)^2
 *
 * is 1 if all cells are equal on the surface.  The sums are without the parts that are smallest in the chart for
 * their area, up to 1 % of the surface.  doc/mathematics.md 3.8.
 */
#ifndef PARTS_H
#define PARTS_H

#include "../base/cmplx.h"
#include "../mesh/mesh.h"

enum { PARTS_ENOMEM = -1 };
enum { PARTS_MOST = 16384 };

/* The parts of a surface: area A on the surface, S in a plane, centre z there. */
typedef struct Parts {
	int             n;
	double         *A, *S;
	double complex *z;
} Parts;

/* Parts of m, which z maps to the plane, of about equal area; at most PARTS_MOST.  Returns 0, or PARTS_ENOMEM with
 * nothing to free. */
int  parts_init(Parts *p, const Mesh *m, const double complex *z);
void parts_free(Parts *p);

/* A face as one part. */
typedef struct PartFace {
	double         A, S;
	double complex z;
} PartFace;

/* Adds about `parts` parts, made of n faces f by halving them by area; f is sorted.  p has room for PARTS_MOST. */
void parts_of_faces(Parts *p, PartFace *f, int n, int parts);

/* chi^2 of n parts with areas A and ratios A/a; a may have any common factor.  And the bound of the ratios from which on
 * parts are left out, if they may be that share of the surface. */
double parts_bound(int n, const double *A, const double *ratio, double share);
double parts_chi2(int n, const double *A, const double *ratio);

/* The share of the surface that the cells lose, up to a factor: the mean over the surface of r/(1 + r/100), where r is
 * the area of a cell on the surface over the mean of all cells.  About chi^2 with all parts while cells are at most ten
 * times as long as the mean; what lies in longer ones is lost, and counts no more than that. */
double parts_lost(int n, const double *A, const double *ratio);

#endif
