/* pillowball.h - closed surfaces on the pillow, exactly conformal (lib/base/pillowplane.h), normals out. */
#ifndef PILLOWBALL_H
#define PILLOWBALL_H

#include "../lib/base/pillowplane.h"
#include "surfaces.h"

/* The unit sphere: H = -1. */
static inline Node
pillowsphere(const PillowPlane *p, double u, double v)
{
	double complex Z[2];
	double a, b;

	pillowplane_z(p, u, v, Z);
	a = creal(Z[0]*conj(Z[0])), b = creal(Z[1]*conj(Z[1]));
	return (Node){ { 2*creal(Z[0]*conj(Z[1]))/(a + b), 2*cimag(Z[0]*conj(Z[1]))/(a + b), (b - a)/(a + b) },
	    pillowplane_round(p, u, v), -1 };
}

/* The height of a surface of revolution at t, whose radius is rho = sech t (1 + a sech^2 t): conformal to the sphere where
 * e^(t + i angle) is the stereographic coordinate, if the height has the derivative (rho^2 - rho'^2)^(1/2). */
static inline double
pear_height(double a, double t)
{
	enum { STEPS = 100 };
	double sum = 0, s, x, q, rho, w;
	int k;

	for (k = 0; k <= STEPS; k++) {
		x = t*k/STEPS;
		s = 1/cosh(x);
		rho = s*(1 + a*s*s);
		q = -tanh(x)*(1 + 2*a*s*s/(1 + a*s*s));
		w = k == 0 || k == STEPS ? 1 : k%2 ? 4 : 2;
		sum += w*rho*sqrt(fmax(1 - q*q, 0));
	}
	return sum*t/(3*STEPS);
}

/* That surface, shifted along its sphere by a Moebius map, then inverted in a sphere: conformal, not symmetric, and H varies. */
static inline void
pillowpear(const PillowPlane *p, double u, double v, double x[3])
{
	double complex Z[2], z[2];
	double t, rho, s, r, y[3], angle;
	int c;

	pillowplane_z(p, u, v, Z);
	z[0] = Z[0] + (0.3 + 0.2*I)*Z[1];
	z[1] = Z[1] + 0.4*I*Z[0];
	t = log(cabs(z[0])/cabs(z[1]));
	angle = carg(z[0]/z[1]);
	s = 1/cosh(t);
	rho = s*(1 - 0.3*s*s);
	y[0] = rho*cos(angle) - 2;
	y[1] = rho*sin(angle) + 1;
	y[2] = -pear_height(-0.3, t) + 1;
	r = y[0]*y[0] + y[1]*y[1] + y[2]*y[2];
	for (c = 0; c < 3; c++)
		x[c] = (c == 2 ? -3 : 3)*y[c]/r;        /* the inversion turns the normal round */
}

#endif
