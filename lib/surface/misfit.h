/* misfit.h - the energy E of a surface for a given conformal factor and mean curvature, its
 * gradient and the matrix of its Gauss-Newton steps.  doc/mathematics.md 6.2, 6.3.
 *
 *   E(phi) = sum over the inner nodes of
 *              o^2 ( <Delta phi, n> - 2 lambda^2 H )^2 T/<lambda^2>             normal
 *     + alpha^2 o^2 ( <Delta phi, phi_u>^2 + <Delta phi, phi_v>^2 ) T/(lambda^2 <lambda^2>)
 *         + w^2 o   ( |phi_u|^2 + |phi_v|^2 - 2 lambda^2 )^2 T/(4 lambda^2 <lambda^2>)
 *         + w^2 o^2 ( (|phi_u|^2 - |phi_v|^2)^2/4 + <phi_u, phi_v>^2 ) T/(lambda^2 <lambda^2>)
 *
 * where <lambda^2> is the mean over the inner nodes.  With w sqrt(T) given, E is the same for a
 * rectangle of any size and for u and v exchanged.  The first two lines are (9), the last two
 * (6).  The differences are those of lambdah.h (stencil.h), so that for a gridded surface and its
 * own lambda and H the first and the third line are 0, to rounding.  The others are 0 only if that
 * grid is conformal; if not, the residual channels nu and tau correct them.  E does not depend on
 * the unit of length.
 *
 * o = 1/(1 + 4 q^2) is the weight of a node by its resolution.  q is the turn of the normal and of
 * the coordinate lines over one cell: q^2 = (h^2 + k^2)/2 (lambda^2 H^2 + 4 |grad log lambda|^2).
 * By truncation, the grid of a conformal map deviates from conformal by about q^2.  The third line
 * is hardly affected by truncation, so it is weighted by o, not o^2.  Where lambda^2 is below 1e-4
 * <lambda^2>, o is 0; with a residue o is multiplied by lambda^2/(1e-4 <lambda^2>) there instead.
 * On a chart with cones o is made of lambda/lambda0 in place of lambda (round.h).
 * Without a residue |H| is clipped so that lambda |H| times a step is at most 2.
 *
 * Where the surface folds over, n is smoothed: once |phi_u x phi_v| is below a thousandth of
 * lambda^2, n goes to 0 with it.  With a residue the area element is known: n = phi_u x
 * phi_v/(lambda^2 a), a = (1 - nu1^2 - nu2^2)^(1/2), and the first line is multiplied by a^2, so
 * that its residual is a polynomial and no normal is singular.
 *
 * Where the boundary is free, border nodes add the last two lines too, with w/10 and
 * differences that are one-sided across the border, of second order like those inside.
 *
 * Vectors of displacements and gradients are three fields [3][nv][nu], 0 on the border unless
 * it is free.
 */
#ifndef MISFIT_H
#define MISFIT_H

#include <stddef.h>

#include "../base/chart.h"

enum { MISFIT_ENOMEM = -1 };

/* The residual channels of a grid that is not quite conformal, each [nv][nu]:
 *
 *   nu1  = (|phi_u|^2 - |phi_v|^2)/(2 lambda^2)      tau1 = <Delta phi, phi_u>/lambda^2
 *   nu2  = <phi_u, phi_v>/lambda^2                   tau2 = <Delta phi, phi_v>/lambda^2
 *
 * With them every line of E is 0 for the surface they come from. */
typedef struct Residue {
	const double *nu[2], *tau[2];
	double truncation;              /* factor of q^2 in o, 0 .. 1.  With residues the minimum of E is 0
	                                 * for any o; o only changes the steps that lead to it */
} Residue;

/* A place: positions that the long waves of the surface follow.  E gains the line
 *
 *   sum over the inner nodes of kappa |phi - place|^2 T/<lambda^2>
 *
 * and the third line is multiplied by 0.01.  The first line resists a wave in proportion to the fourth
 * power of its wave number.  So with kappa the fourth power of a wave number, waves above that number
 * follow lambda and H, and waves below it follow the place.  doc/mathematics.md 6.8. */
typedef struct MisfitPlace {
	const double *phi;              /* [3][nv][nu] */
	double        s;                /* a length: the place has hardly any waves of wave number above 1/s,
	                                 * in radians per unit of length on the surface */
} MisfitPlace;

typedef struct Misfit {
	Chart          g;
	double         w, alpha;        /* w per unit of u: a wave number over sqrt(T) */
	double         scale;           /* T/<lambda^2> */
	double         blur;            /* n = c/(|c|^2 + blur lambda^4)^(1/2), c = phi_u x phi_v */
	double        *lambda2, *l2H2;  /* [nv][nu] lambda^2 and 2 lambda^2 H */
	double        *o;               /* [nv][nu] */
	double        *round;           /* [nv][nu] lambda0^2 over its mean, or NULL (round.h) */
	double        *firm;            /* [nv][nu] factor of the first two lines, or NULL: 1 */
	double        *row, *work;      /* workspace: sums of rows; adjoint rows */
	const Residue *residue;         /* or NULL */
	int            free;            /* the border nodes are unknowns */
	const double  *place;           /* or NULL */
	double        *hold;            /* [nv][nu] kappa T/<lambda^2>, or NULL */
	double         stiffness;       /* the part of hold that is equal at all inner nodes, for the plate */
	double         stretch;         /* factor of the third line: 1, or 0.01 with a place */
} Misfit;

/* Copies lambda2 = lambda^2 > 0 and l2H = lambda^2 H; keeps the pointer residue (or NULL).  The
 * caller then sets w and alpha.  g has at least 3 nodes in each direction.  Returns 0 or
 * MISFIT_ENOMEM; m then holds nothing to free. */
int  misfit_init(Misfit *m, Chart g, const double *lambda2, const double *l2H, const Residue *residue);
void misfit_free(Misfit *m);

/* Makes the boundary free.  Residues are not defined on the border, so the target there is a
 * conformal metric. */
void misfit_set_free(Misfit *m);

/* For lambda and H that belong to no surface: on a chart with cones, multiplies the first two lines by
 *
 *   1 + (reach/r)^2,    r the distance from the nearest cone, in units of u.
 *
 * A spike like r^2 log r has finite energy without this, and infinite energy with it, as spikes of smooth
 * surfaces have.  Data of a surface have no spikes, and are fitted better without.  reach = 0 changes
 * nothing.  Returns 0 or MISFIT_ENOMEM. */
int  misfit_set_firm(Misfit *m, double reach);

/* Holds the surface at a place and keeps the pointer place->phi; NULL: does not hold it any more.
 * Returns 0 or MISFIT_ENOMEM. */
int  misfit_hold(Misfit *m, const MisfitPlace *place);

/* E; and the node with the largest contribution to it, an inner one unless the boundary is free. */
double misfit_energy(const Misfit *m, const double *phi);
size_t misfit_worst(const Misfit *m, const double *phi);

/* The root mean square of (|phi_u|^2 + |phi_v|^2)/(2 lambda^2) - 1 weighted by o^2
 * lambda^2: the relative error of the metric. */
double misfit_scale_error(const Misfit *m, const double *phi);

/* With r the weighted residuals, E = |r|^2, and J their derivative at phi: misfit_gradient is J'r,
 * half the gradient of E, and misfit_normal is J'J d for a displacement d. */
void misfit_gradient(const Misfit *m, const double *phi, double *g);
void misfit_normal(const Misfit *m, const double *phi, const double *d, double *g);

#endif
