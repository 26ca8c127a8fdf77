/* frame.h - the surface with given lambda and H, by the paper's frame method (doc/mathematics.md
 * 7).
 *
 * Three linear least squares problems one after the other, all on cell centres:
 *
 *   Codazzi     D_u + M_v = lambda^2 H_u,  D_v - M_u = -lambda^2 H_v   for D = (L-N)/2, M   (14)
 *   frame       (p, q, n) = (phi_u, phi_v, n) from the natural frame equations, which are
 *               the same for x, y and z: one matrix, three right-hand sides         (13), (30)
 *   position    phi_u = p, phi_v = q                                                    (31)
 *
 * The Codazzi system replaces (15), the paper's Poisson equation for mu = (D - i M)/2, which follows
 * from it by one more differentiation.
 *
 * Before the position, p and q are made orthogonal and of length lambda.  The linear system does not
 * contain these conditions, and where H is large it shrinks the frame ("mkmesh -n 60000 cortex" at
 * 129 x 129 has area 139; the result has 105 without this step, 133 with it).
 *
 * phi is given on the three outer rings (the neighbourhood V of Theorem 1, (8)); they determine the
 * frame and the second fundamental form on the second ring.  The chart is a rectangle.
 */
#ifndef FRAME_H
#define FRAME_H

#include "../base/chart.h"
#include "../sparse/spd.h"

enum { FRAME_BAND = 3 };        /* rings of phi that are given */

enum { FRAME_EBAND = -10 };     /* the band has no tangent plane at node *at */

/* lambda, H  in      [nv][nu]; lambda > 0
 * phi        in/out  x, y, z, each [nv][nu]: the band is given, the rest computed
 *
 * Grids of fewer than 7 nodes in a direction are all band and stay as they are.
 * Returns 0, FRAME_EBAND, SPD_ENOMEM, SPD_EINDEFINITE or SPD_ELARGE; phi is then
 * unspecified.  report may be NULL. */
int frame_surface(Chart g, const double *lambda, const double *H, double *const phi[3],
	int *at, SpdReport *report);

/* The same on a coarser grid g: a start for the surface method (surface.h).  The border of phi
 * holds the boundary curve; frame and second form there are taken from the band of the fine grid,
 * linear between its nodes, to first order in the steps.  *at is a node of the fine grid.  Returns as
 * frame_surface. */
int frame_coarse(Chart fine, double *const band[3], Chart g, const double *lambda, const double *H,
	double *const phi[3], int *at, SpdReport *report);

/* Replaces p and q by the orthogonal pair of length lambda that is nearest in the least squares
 * sense; a pair that is parallel or 0 stays as it is. */
void frame_make_conformal(double lambda, double p[3], double q[3]);

#endif
