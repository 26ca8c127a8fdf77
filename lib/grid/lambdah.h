/* lambdah.h - from an immersion of the chart to its conformal factor and mean curvature. */
#ifndef LAMBDAH_H
#define LAMBDAH_H

#include "../base/chart.h"

/* How H is taken from the Laplacian of phi. */
enum {
	LAMBDAH_NORMAL,         /* its part along n: H = <Delta phi, n>/(2 lambda^2) */
	LAMBDAH_MAGNITUDE       /* its length, as the paper's (26): the same for an exactly
	                         * conformal grid, else it counts the tangential error too */
};

/* lambda and H of phi, at least 4 nodes in either direction.
 *
 *   lambda^2 = (|phi_u|^2 + |phi_v|^2)/2                                     (25)
 *   H        = <phi_uu + phi_vv, n>/(2 lambda^2)                             (26)-(29)
 *
 * Inside, central differences of second order with steps h and k.  On the outermost ring
 * nothing is differenced, as a corner of the rectangle is a square-root singularity of
 * the map: H goes on linearly and lambda geometrically from the two rings within, the
 * step of lambda held between 1/2 and 2 and that of H to the size of the inner value.
 *
 * lambda is at least 1e-4 of its root mean square; H is 0 where phi has no tangent
 * plane.  phi, lambda and H are [nv][nu].  Returns the number of inner nodes where
 * lambda was raised or H set so. */
int lambdah(Chart g, const double *const phi[3], int curvature, double *lambda, double *H);

/* |H| within eight nodes of a corner, of grids larger than 24 nodes, held to four times its
 * root mean square elsewhere. */
void lambdah_limit_corners(Chart g, double *H);

/* What (lambda, H) do not say of a grid that is not quite conformal: at inner nodes, else 0,
 *
 *   nu[0] = (|phi_u|^2 - |phi_v|^2)/(2 lambda^2)     tau[0] = <Delta phi, phi_u>/lambda^2
 *   nu[1] = <phi_u, phi_v>/lambda^2                  tau[1] = <Delta phi, phi_v>/lambda^2 */
void lambdah_residue(Chart g, const double *const phi[3], const double *lambda, double *const nu[2],
	double *const tau[2]);

/* Modulus of the Beltrami coefficient of phi at each inner node, (nu-2)*(nv-2) values
 * in row order: 0 where phi is conformal, 1 where it has no tangent plane.
 *
 *   |mu_B|^2 = (E + G - 2 sqrt(EG - F^2))/(E + G + 2 sqrt(EG - F^2)) */
void beltrami(Chart g, const double *const phi[3], double *mu);

#endif
