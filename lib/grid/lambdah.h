/* lambdah.h - conformal factor and mean curvature of a gridded surface. */
#ifndef LAMBDAH_H
#define LAMBDAH_H

#include "../base/chart.h"

/* How H is computed from the Laplacian of phi. */
enum {
	LAMBDAH_NORMAL,         /* its part along n: H = <Delta phi, n>/(2 lambda^2) */
	LAMBDAH_MAGNITUDE       /* its length, the paper's (26): the same for an exactly conformal
	                         * grid; on others it includes the tangential error */
};

/* Numbers of inner nodes where lambda or H does not have the value of the equations. */
typedef struct LambdahFlaws {
	int raised;             /* lambda was below its least value, or H not finite; H is 0 */
	int parallel;           /* phi_u and phi_v are parallel, to rounding; H is 0 */
} LambdahFlaws;

/* lambda and H of phi, at least 4 nodes in either direction.
 *
 *   lambda^2 = (|phi_u|^2 + |phi_v|^2)/2                                     (25)
 *   H        = <phi_uu + phi_vv, n>/(2 lambda^2)                             (26)-(29)
 *
 * Inside: central differences of second order with steps h and k.  On the outermost ring no
 * differences are used, as a corner of the rectangle is a square-root singularity of the map.  H
 * is extrapolated linearly and lambda geometrically from the two rings inside it; the ratio for
 * lambda is limited to [1/2, 2] and the increment of H to |H| of the inner ring.
 * doc/mathematics.md 4.3, 4.4.
 *
 * lambda is at least 1e-4 of its root mean square.  phi, lambda and H are [nv][nu].
 *
 * The Gauss curvature K = -(Delta log lambda)/lambda^2 (10) follows from lambda; no program
 * needs it. */
LambdahFlaws lambdah(Chart g, const double *const phi[3], int curvature, double *lambda, double *H);

/* Limits |H| within eight nodes of a corner to four times its root mean square elsewhere, if the grid
 * has more than 24 nodes in both directions. */
void lambdah_limit_corners(Chart g, double *H);

/* The residual channels: the part of the fundamental forms that (lambda, H) do not determine on
 * a grid that is not quite conformal; at inner nodes, 0 at others (doc/mathematics.md 6.7).
 *
 *   nu[0] = (|phi_u|^2 - |phi_v|^2)/(2 lambda^2)     tau[0] = <Delta phi, phi_u>/lambda^2
 *   nu[1] = <phi_u, phi_v>/lambda^2                  tau[1] = <Delta phi, phi_v>/lambda^2 */
void lambdah_residue(Chart g, const double *const phi[3], const double *lambda, double *const nu[2],
	double *const tau[2]);

/* Modulus of the Beltrami coefficient of phi at each inner node, stencil_inner_count(g) values
 * in row order: 0 where phi is conformal, 1 where it has no tangent plane.
 *
 *   |mu_B|^2 = (E + G - 2 sqrt(EG - F^2))/(E + G + 2 sqrt(EG - F^2)) */
void beltrami(Chart g, const double *const phi[3], double *mu);

#endif
