/* surfaces.h - conformal immersions whose lambda and H are known in closed form.
 *
 * Tests should use charts with nu != nv, h != k and T != 1: otherwise a test cannot notice that
 * u and v, or h and k, are exchanged.  stereo and enneper are shifted so that they are not
 * symmetric in u or v: on a symmetric surface <phi_u, phi_uu> may be 0 at the border, and then a
 * first-order error there goes unnoticed.
 */
#ifndef SURFACES_H
#define SURFACES_H

#include <math.h>
#include <stddef.h>

#include "../lib/base/chart.h"

typedef struct Node {
	double x[3], lambda, H;
} Node;

typedef Node Immersion(double u, double v);

/* The unit sphere seen from inside: H = +1. */
static inline Node
stereo(double u, double v)
{
	double x = u + 0.3, y = v + 0.2, r = 1 + x*x + y*y;

	return (Node){ { 2*x/r, 2*y/r, 1 - 2/r }, 2/r, 1 };
}

/* A cylinder of radius 2 whose normal points out: H = -1/4. */
static inline Node
cylinder(double u, double v)
{
	return (Node){ { 2*cos(u), 2*sin(u), 2*v }, 2, -0.25 };
}

static inline Node
catenoid(double u, double v)
{
	double c = cosh(v - 0.1);

	return (Node){ { c*cos(u), c*sin(u), v - 0.1 }, c, 0 };
}

static inline Node
enneper(double u, double v)
{
	double x = u - 0.2, y = v + 0.1;

	return (Node){ { x - x*x*x/3 + x*y*y, y - y*y*y/3 + y*x*x, x*x - y*y }, 1 + x*x + y*y, 0 };
}

/* A torus of radii sqrt(2) and 1 whose normal points out: the only surface here whose H varies. */
static inline Node
torus(double u, double v)
{
	double R = sqrt(2), t = 2*atan((R + 1)*tan((v - 0.1)/2)), l = R + cos(t);

	return (Node){ { l*cos(u), l*sin(u), sin(t) }, l, -(1 + cos(t)/l)/2 };
}

static inline Node
plane(double u, double v)
{
	return (Node){ { 3*u, 3*v, 1 }, 3, 0 };
}

/* Samples the surface, scaled by s, at the nodes of g; any of phi, lambda and H may be NULL. */
static inline void
sample_immersion(Immersion *f, Chart g, double s, double *phi[3], double *lambda, double *H)
{
	int i, j, c, p;

	for (p = 0, j = 0; j < g.nv; j++)
		for (i = 0; i < g.nu; i++, p++) {
			Node n = f(i/(g.nu - 1.0), j*g.T/(g.nv - 1));

			for (c = 0; c < 3 && phi; c++)
				phi[c][p] = s*n.x[c];
			if (lambda)
				lambda[p] = s*n.lambda;
			if (H)
				H[p] = n.H/s;
		}
}

/* The largest absolute difference of two fields, or NaN if any difference is NaN. */
static inline double
largest(size_t n, const double *a, const double *b)
{
	double max = 0;
	size_t p;

	for (p = 0; p < n && !isnan(max); p++)
		if (!(fabs(a[p] - b[p]) <= max))
			max = fabs(a[p] - b[p]);
	return max;
}

/* The next pseudo-random number in [-1,1], the same in every run. */
static inline double
noise(unsigned long long *state)
{
	*state = *state*6364136223846793005u + 1442695040888963407u;
	return (double)(*state >> 11)/(1ull << 52) - 1;
}

#endif
