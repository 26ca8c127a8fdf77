/* synth_closed.c - closed surfaces, over the unit sphere. */
#include <math.h>

#include "synth_shapes.h"

static void
sphere_domain(const double *p, SynthDomain *d)
{
	(void)p;
	d->shape = SYNTH_SPHERE;
	d->x0 = d->y0 = -1;
	d->x1 = 1 + SYNTH_FAR;
	d->y1 = 1;
}

/* The point of the unit sphere, and the conformal factor there. */
static double
on_sphere(double x, double y, double X[3])
{
	int far = x > SYNTH_FAR/2.;
	double r2;

	x -= far ? SYNTH_FAR : 0;
	r2 = x*x + y*y;
	X[0] = 2*x/(1 + r2);
	X[1] = (far ? -2 : 2)*y/(1 + r2);
	X[2] = (far ? r2 - 1 : 1 - r2)/(1 + r2);
	return 2/(1 + r2);
}

static void
sphere_phi(const double *p, double x, double y, double xyz[3])
{
	int c;

	on_sphere(x, y, xyz);
	for (c = 0; c < 3; c++)
		xyz[c] *= p[0];
}

static double
sphere_lambda(const double *p, double x, double y)
{
	double X[3];

	return p[0]*on_sphere(x, y, X);
}

static double
sphere_H(const double *p, double x, double y)
{
	(void)x, (void)y;
	return -1/p[0];
}

static void
ellipsoid_phi(const double *p, double x, double y, double xyz[3])
{
	int c;

	on_sphere(x, y, xyz);
	for (c = 0; c < 3; c++)
		xyz[c] *= p[c];
}

/* The square root of the ratio of areas: nX over the semi-axes is the normal. */
static double
ellipsoid_scale(const double *p, double x, double y)
{
	double X[3], lambda = on_sphere(x, y, X), sum = 0;
	int c;

	for (c = 0; c < 3; c++)
		sum += X[c]*X[c]/(p[c]*p[c]);
	return lambda*sqrt(p[0]*p[1]*p[2]*sqrt(sum));
}

static void
bumpy_phi(const double *p, double x, double y, double xyz[3])
{
	double X[3], r;
	int c;

	on_sphere(x, y, X);
	r = 1 + p[0]*(X[0]*X[1] + 0.6*X[2]*X[2]*X[2] + 0.8*X[0]*X[2]*(5*X[1]*X[1] - 1));
	for (c = 0; c < 3; c++)
		xyz[c] = r*X[c];
}

static double
bumpy_scale(const double *p, double x, double y)
{
	double X[3];

	(void)p;
	return on_sphere(x, y, X);
}

const SynthKind synth_closed[] = {
	{ "sphere", "R X, X on the unit sphere: closed; lambda = 2R/(1+r^2), H = -1/R\n",
	  { { "R", 1, 0.001, 1000 } }, sphere_domain, sphere_phi, sphere_lambda, sphere_H, NULL },
	{ "ellipsoid",
	  "(a X, b Y, c Z), (X,Y,Z) on the unit sphere: closed; H = h^3 (|phi|^2-a^2-b^2-c^2)/\n"
	  "(2 (abc)^2), 1/h^2 = (X/a)^2 + (Y/b)^2 + (Z/c)^2\n",
	  { { "a", 1.5, 0.05, 20 }, { "b", 1, 0.05, 20 }, { "c", 0.7, 0.05, 20 } }, sphere_domain, ellipsoid_phi, NULL,
	  NULL, ellipsoid_scale },
	{ "bumpy",
	  "r (X,Y,Z), (X,Y,Z) on the unit sphere: closed; r = 1 + amp (XY + .6 Z^3 +\n"
	  ".8 XZ (5 Y^2 - 1))\n",
	  { { "amp", 0.3, 0, 0.5 } }, sphere_domain, bumpy_phi, NULL, NULL, bumpy_scale },
	{ NULL, NULL, { { NULL, 0, 0, 0 } }, NULL, NULL, NULL, NULL, NULL }
};
