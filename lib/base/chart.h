/* chart.h - the parameter rectangle [0,1] x [0,T] and its nodes.
 *
 * Symbols used in lib/ without further comment (DESIGN: README, section Mathematics):
 *
 *   phi      position in R^3 at node (i,j): arrays phi[0], phi[1], phi[2] = x, y, z
 *   h, k     grid steps, h = 1/(nu-1) along u, k = T/(nv-1) along v
 *   lambda   conformal factor > 0: |phi_u| = |phi_v| = lambda, <phi_u, phi_v> = 0
 *   n        unit normal, phi_u x phi_v / |phi_u x phi_v|
 *   H        mean curvature, <Delta phi, n> / (2 lambda^2); -1 on the unit sphere whose
 *            normal points out
 *   p        node number j*nu + i, u fastest
 *
 * phi and lambda have the unit of length of the mesh, H one over it; u, v, T have none.
 */
#ifndef CHART_H
#define CHART_H

typedef struct Chart {
	int    nu, nv;          /* nodes along u and v */
	double T;               /* height, > 0 */
} Chart;

static inline double
chart_h(Chart g)
{
	return 1.0/(g.nu - 1);
}

static inline double
chart_k(Chart g)
{
	return g.T/(g.nv - 1);
}

#endif
