/* lambdah.h - conformal factor and mean curvature of a gridded surface. */
#ifndef LAMBDAH_H
#define LAMBDAH_H

#include "../base/chart.h"

/* How H is computed from the Laplacian of phi. */
enum {
	LAMBDAH_NORMAL,         /* its normal component: H = <Delta phi, n>/(2 lambda^2) */
	LAMBDAH_MAGNITUDE       /* its length with the sign of <Delta phi, n>, (26) of the paper:
	                         * equal to LAMBDAH_NORMAL on an exactly conformal grid; on others
	                         * it contains a tangential error */
};

/* The numbers of inner nodes at which lambda or H were replaced. */
typedef struct LambdahFlaws {
	int raised;             /* lambda was below its lower bound, or H infinite: lambda is set to
	                         * that bound, H to 0 */
	int parallel;           /* phi_u and phi_v were parallel up to rounding: H is 0 */
} LambdahFlaws;

/* lambda and H of phi.  The grid has at least 4 nodes in either direction.
 *
 *   lambda^2 = (|phi_u|^2 + |phi_v|^2)/2                                     (25)
 *   H        = <phi_uu + phi_vv, n>/(2 lambda^2)                             (26)-(29)
 *
 * At inner nodes the derivatives are central differences of second order, with steps h and k.  On the
 * outermost ring no differences are used, because the map has square-root singularities at the
 * corners of the rectangle.  There H is extrapolated linearly and lambda geometrically from the
 * next two rings: the ratio for lambda is limited to [1/2, 2], and the increment of H to |H| on the
 * next ring.  doc/mathematics.md 4.3, 4.4.
 *
 * At inner nodes lambda is at least 1e-4 of its root mean square.  phi, lambda and H are [nv][nu].
 *
 * The Gauss curvature K = -(Delta log lambda)/lambda^2 (10) follows from lambda; no program
 * needs it. */
LambdahFlaws lambdah(Chart g, const double *const phi[3], int curvature, double *lambda, double *H);

/* Limits |H| within eight nodes of a corner to four times its root mean square elsewhere, if the
 * grid has more than 24 nodes in both directions. */
void lambdah_limit_corners(Chart g, double *H);

/* The residual channels: the part of the first derivatives and of the Laplacian of phi that lambda
 * and H do not determine when the grid is not quite conformal (doc/mathematics.md 6.7).  They are
 * computed at inner nodes and 0 at all others.
 *
 *   nu[0] = (|phi_u|^2 - |phi_v|^2)/(2 lambda^2)     tau[0] = <Delta phi, phi_u>/lambda^2
 *   nu[1] = <phi_u, phi_v>/lambda^2                  tau[1] = <Delta phi, phi_v>/lambda^2 */
void lambdah_residue(Chart g, const double *const phi[3], const double *lambda, double *const nu[2],
	double *const tau[2]);

/* Modulus of the Beltrami coefficient of phi at the inner nodes: stencil_inner_count(g) values, row
 * by row.  It is 0 where phi is conformal, and 1 where the surface has no tangent plane.
 *
 *   |mu_B|^2 = (E + G - 2 sqrt(EG - F^2))/(E + G + 2 sqrt(EG - F^2)) */
void beltrami(Chart g, const double *const phi[3], double *mu);

#endif
