/* sockcap.h - a cap of the unit sphere on the sock, exactly conformal (lib/base/sockplane.h).
 *
 * The stereographic radius c of the cap is 1 for a hemisphere, and goes to 0 for a flat disk.  The
 * sphere is seen from inside, as stereo of surfaces.h: H = +1. */
#ifndef SOCKCAP_H
#define SOCKCAP_H

#include "../lib/base/sockplane.h"
#include "surfaces.h"

static inline Node
sockcap(const SockPlane *p, double c, double u, double v)
{
	double complex z = c*sockplane_z(p, u, v);
	double x = creal(z), y = cimag(z), r = 1 + x*x + y*y;

	return (Node){ { 2*x/r, 2*y/r, 1 - 2/r }, 2*c*sockplane_stretch(p, u, v)/r, 1 };
}

/* Samples the cap at the nodes of the sock g; any of phi, lambda and H may be NULL. */
static inline void
sample_sockcap(Chart g, double c, double *const phi[3], double *lambda, double *H)
{
	SockPlane plane = sockplane(g.T);
	int p, k;

	for (p = 0; p < g.nu*g.nv; p++) {
		Node n = sockcap(&plane, c, chart_u(g, p%g.nu), chart_v(g, p/g.nu));

		for (k = 0; k < 3 && phi; k++)
			phi[k][p] = n.x[k];
		if (lambda)
			lambda[p] = n.lambda;
		if (H)
			H[p] = n.H;
	}
}

#endif
