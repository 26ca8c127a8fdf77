/* misfit.h - how far a surface is from a conformal factor and a mean curvature.
 *
 *   E(phi) = sum over the inner nodes of
 *              o^2 ( <Delta phi, n> - 2 lambda^2 H )^2 / <lambda^2>              normal
 *     + alpha^2 o^2 ( <Delta phi, phi_u>^2 + <Delta phi, phi_v>^2 ) / (lambda^2 <lambda^2>)
 *         + w^2 o   ( |phi_u|^2 + |phi_v|^2 - 2 lambda^2 )^2 / (4 lambda^2 <lambda^2>)
 *         + w^2 o^2 ( (|phi_u|^2 - |phi_v|^2)^2/4 + <phi_u, phi_v>^2 ) / (lambda^2 <lambda^2>)
 *
 * with <lambda^2> the mean over the inner nodes, central differences and the five-point
 * Laplacian: those by which lambda and H are taken from a surface (lambdah.h), so that the
 * first and the third line are 0 for the surface they were taken from, to the last bit.
 * The others are 0 only if that grid is conformal: where it is not, nu and tau say so.
 * E is free of the unit of length.
 *
 * o = 1/(1 + 4 q^2) is the weight of a node by its resolution: q^2 = (h^2 + k^2)/2
 * (lambda^2 H^2 + 4 |grad log lambda|^2), the turn of the normal and of the coordinate lines over one cell.
 * Truncation makes of a conformal map a grid that is off by about q^2.  The third line,
 * which holds all the same, is trusted more.  o = 0 where lambda < 0.01 <lambda^2>^(1/2),
 * and |H| is clipped so that lambda |H| times a step is <= 2 (doc/mathematics.md 6.3).
 *
 * n is smooth where the surface folds over: it is 0 where phi_u x phi_v is, over a thousandth
 * of lambda^2 (not with a residue, where such places are not to be).
 *
 * Where the boundary is free, the border nodes add the last two lines too, with w/10 and
 * differences that are one-sided across the border, of the second order as those inside.
 *
 * Vectors of displacements and gradients are three fields [3][nv][nu], 0 on the border unless
 * it is free.
 */
#ifndef MISFIT_H
#define MISFIT_H

#include <stddef.h>

#include "../base/chart.h"

enum { MISFIT_ENOMEM = -1 };

/* What lambda and H do not say of a grid that is not quite conformal, each [nv][nu]:
 *
 *   nu1  = (|phi_u|^2 - |phi_v|^2)/(2 lambda^2)      tau1 = <Delta phi, phi_u>/lambda^2
 *   nu2  = <phi_u, phi_v>/lambda^2                   tau2 = <Delta phi, phi_v>/lambda^2
 *
 * With them every line of E is 0 for the surface they come from. */
typedef struct Residue {
	const double *nu[2], *tau[2];
} Residue;

typedef struct Misfit {
	Chart          g;
	double         w, alpha;
	double         scale;           /* 1/<lambda^2> */
	double         blur;            /* n = c/(|c|^2 + blur lambda^4)^(1/2), c = phi_u x phi_v */
	double        *lambda2, *l2H2;  /* [nv][nu] lambda^2 and 2 lambda^2 H */
	double        *o;               /* [nv][nu] */
	double        *row, *work;      /* of the sums and of the products */
	const Residue *residue;         /* or NULL */
	int            free;            /* the border nodes are unknowns */
} Misfit;

/* The fields lambda2 = lambda^2 > 0 and l2H = lambda^2 H are read, residue (or NULL) is kept.
 * w and alpha are to be set.  g has at least 3 nodes in either direction.  Returns 0 or
 * MISFIT_ENOMEM; m then holds nothing to free. */
int  misfit_init(Misfit *m, Chart g, const double *lambda2, const double *l2H, const Residue *residue);
void misfit_free(Misfit *m);

/* From now on the boundary is free.  Residues are not defined on the border, which is held to
 * be conformal. */
void misfit_set_free(Misfit *m);

/* E, and the node that has the largest part of it: an inner one unless the boundary is free. */
double misfit_energy(const Misfit *m, const double *phi);
size_t misfit_worst(const Misfit *m, const double *phi);

/* The root mean square of (|phi_u|^2 + |phi_v|^2)/(2 lambda^2) - 1 weighted by o^2
 * lambda^2: how far the surface is from having the metric that was asked for. */
double misfit_scale_error(const Misfit *m, const double *phi);

/* With J the derivative of the weighted residuals r at phi, E = |r|^2: J'r, half the
 * gradient of E, and J'J d, for displacements d. */
void misfit_gradient(const Misfit *m, const double *phi, double *g);
void misfit_normal(const Misfit *m, const double *phi, const double *d, double *g);

#endif
