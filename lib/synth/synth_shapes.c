/* synth_shapes.c - plane pieces and patches of classical surfaces, in conformal coordinates. */
#include <math.h>

#include "synth_shapes.h"

static const double DEG = 3.14159265358979323846/180;

static void
box(SynthDomain *d, double x0, double x1, double y0, double y1)
{
	d->shape = SYNTH_RECT;
	d->x0 = x0, d->x1 = x1;
	d->y0 = y0, d->y1 = y1;
}

static void
disk(SynthDomain *d, double r)
{
	box(d, -r, r, -r, r);
	d->shape = SYNTH_OVAL;
}

static void
put(double xyz[3], double x, double y, double z)
{
	xyz[0] = x;
	xyz[1] = y;
	xyz[2] = z;
}

static double
one(const double *p, double x, double y)
{
	(void)p, (void)x, (void)y;
	return 1;
}

static double
zero(const double *p, double x, double y)
{
	(void)p, (void)x, (void)y;
	return 0;
}

static void
flat_phi(const double *p, double x, double y, double xyz[3])
{
	(void)p;
	put(xyz, x, y, 0);
}

static void
rectangle_domain(const double *p, SynthDomain *d)
{
	box(d, 0, p[0], 0, p[1]);
}

static void
lshape_domain(const double *p, SynthDomain *d)
{
	box(d, 0, p[0], 0, p[0]);
	d->shape = SYNTH_LSHAPE;
}

/* z -> r0 exp(z) maps the rectangle to the sector. */
static void
sector_domain(const double *p, SynthDomain *d)
{
	box(d, 0, log(p[1]/p[0]), 0, DEG*p[2]);
}

static void
sector_phi(const double *p, double x, double y, double xyz[3])
{
	double r = p[0]*exp(x);

	put(xyz, r*cos(y), r*sin(y), 0);
}

static double
sector_lambda(const double *p, double x, double y)
{
	(void)y;
	return p[0]*exp(x);
}

static void
cap_domain(const double *p, SynthDomain *d)
{
	disk(d, tan(DEG*p[1]/2));
}

static void
cap_phi(const double *p, double x, double y, double xyz[3])
{
	double r2 = x*x + y*y, s = p[0]/(1 + r2);

	put(xyz, 2*s*x, 2*s*y, s*(1 - r2));
}

static double
cap_lambda(const double *p, double x, double y)
{
	return 2*p[0]/(1 + x*x + y*y);
}

static double
sphere_H(const double *p, double x, double y)
{
	(void)x, (void)y;
	return -1/p[0];
}

static void
mercator_domain(const double *p, SynthDomain *d)
{
	box(d, 0, DEG*p[1], asinh(tan(DEG*p[2])), asinh(tan(DEG*p[3])));
}

static void
mercator_phi(const double *p, double x, double y, double xyz[3])
{
	put(xyz, p[0]*cos(x)/cosh(y), p[0]*sin(x)/cosh(y), p[0]*tanh(y));
}

static double
mercator_lambda(const double *p, double x, double y)
{
	(void)x;
	return p[0]/cosh(y);
}

static void
cylinder_domain(const double *p, SynthDomain *d)
{
	box(d, 0, p[0]*DEG*p[1], 0, p[2]);
}

static void
cylinder_phi(const double *p, double x, double y, double xyz[3])
{
	put(xyz, p[0]*cos(x/p[0]), p[0]*sin(x/p[0]), y);
}

static double
cylinder_H(const double *p, double x, double y)
{
	(void)x, (void)y;
	return -1/(2*p[0]);
}

static void
catenoid_domain(const double *p, SynthDomain *d)
{
	box(d, 0, DEG*p[1], p[2], p[3]);
}

static void
catenoid_phi(const double *p, double x, double y, double xyz[3])
{
	put(xyz, p[0]*cosh(y)*cos(x), p[0]*cosh(y)*sin(x), p[0]*y);
}

static double
catenoid_lambda(const double *p, double x, double y)
{
	(void)x;
	return p[0]*cosh(y);
}

/* On the torus |phi_y| = r v'(y) must be |phi_x| = R + r cos v: with q = sqrt(R^2 - r^2),
 * the integral of r dv/(R + r cos v) is y = (2r/q) atan(sqrt((R-r)/(R+r)) tan(v/2)). */
static double
torus_y(const double *p, double v)
{
	double R = p[0], r = p[1], q = sqrt(R*R - r*r);

	return 2*r/q*atan(sqrt((R - r)/(R + r))*tan(v/2));
}

static double
torus_v(const double *p, double y)
{
	double R = p[0], r = p[1], q = sqrt(R*R - r*r);

	return 2*atan(sqrt((R + r)/(R - r))*tan(y*q/(2*r)));
}

static void
torus_domain(const double *p, SynthDomain *d)
{
	if (p[1] < p[0])        /* otherwise the tube meets itself, and the box stays empty: an error */
		box(d, 0, DEG*p[2], torus_y(p, DEG*p[3]), torus_y(p, DEG*p[4]));
}

static double
torus_lambda(const double *p, double x, double y)
{
	(void)x;
	return p[0] + p[1]*cos(torus_v(p, y));
}

static void
torus_phi(const double *p, double x, double y, double xyz[3])
{
	double l = torus_lambda(p, x, y);

	put(xyz, l*cos(x), l*sin(x), p[1]*sin(torus_v(p, y)));
}

/* Half the sum of the principal curvatures -1/r and -cos v/(R + r cos v). */
static double
torus_H(const double *p, double x, double y)
{
	return -(1/p[1] + cos(torus_v(p, y))/torus_lambda(p, x, y))/2;
}

static void
enneper_domain(const double *p, SynthDomain *d)
{
	disk(d, p[1]);
}

static void
enneper_phi(const double *p, double x, double y, double xyz[3])
{
	put(xyz, p[0]*(x - x*x*x/3 + x*y*y), p[0]*(y - y*y*y/3 + x*x*y), p[0]*(x*x - y*y));
}

static double
enneper_lambda(const double *p, double x, double y)
{
	return p[0]*(1 + x*x + y*y);
}

const SynthKind synth_shapes[] = {
	{ "rectangle", "(x, y, 0) on [0,a] x [0,b]; T = b/a\n",
	  { { "a", 1.5, 0.01, 100 }, { "b", 1, 0.01, 100 } },
	  rectangle_domain, flat_phi, one, zero, NULL },
	{ "lshape",
	  "(x, y, 0) on [0,a] x [0,a] without its upper right quarter; corners (0,0) (a,0)\n"
	  "(a/2,a/2) (0,a): the diagonal is a mirror that keeps corners 0, 2 and exchanges\n"
	  "1, 3, so u and v change places and T = 1/T = 1\n",
	  { { "a", 2, 0.01, 100 } },
	  lshape_domain, flat_phi, one, zero, NULL },
	{ "sector",
	  "r0 e^x (cos y, sin y, 0), 0 <= x <= log(r1/r0), 0 <= y <= angle: a piece of an\n"
	  "annulus; lambda = r0 e^x, T = angle/log(r1/r0)\n",
	  { { "r0", 1, 0.1, 10 }, { "r1", 3, 0.1, 10 }, { "angle", 120, 1, 350 } },
	  sector_domain, sector_phi, sector_lambda, zero, NULL },
	{ "cap",
	  "R (2x, 2y, 1-r^2)/(1+r^2), r^2 = x^2+y^2, r <= tan(angle/2): a sphere as far as\n"
	  "angle from its pole; lambda = 2R/(1+r^2), H = -1/R, T = 1\n",
	  { { "R", 1, 0.001, 1000 }, { "angle", 60, 1, 135 } },
	  cap_domain, cap_phi, cap_lambda, sphere_H, NULL },
	{ "mercator",
	  "R (cos x/cosh y, sin x/cosh y, tanh y), longitude x to angle, latitude\n"
	  "atan(sinh y) from south to north; lambda = R/cosh y, H = -1/R\n",
	  { { "R", 1, 0.001, 1000 }, { "angle", 90, 1, 350 }, { "south", -20, -80, 80 },
	    { "north", 55, -80, 80 } },
	  mercator_domain, mercator_phi, mercator_lambda, sphere_H, NULL },
	{ "cylinder",
	  "(R cos(x/R), R sin(x/R), y), x/R to angle, 0 <= y <= b; lambda = 1, H = -1/(2R)\n",
	  { { "R", 1, 0.001, 1000 }, { "angle", 150, 1, 350 }, { "b", 2, 0.001, 1000 } },
	  cylinder_domain, cylinder_phi, one, cylinder_H, NULL },
	{ "catenoid",
	  "a (cosh y cos x, cosh y sin x, y), x to angle, y0 <= y <= y1; lambda = a cosh y,\n"
	  "H = 0\n",
	  { { "a", 1, 0.001, 1000 }, { "angle", 150, 1, 350 }, { "y0", -0.6, -3, 3 },
	    { "y1", 1.2, -3, 3 } },
	  catenoid_domain, catenoid_phi, catenoid_lambda, zero, NULL },
	{ "torus",
	  "(l cos x, l sin x, r sin v), l = R + r cos v, x to angle, v from v0 to v1, where\n"
	  "tan(v/2) = sqrt((R+r)/(R-r)) tan(y sqrt(R^2-r^2)/(2r)); lambda = l,\n"
	  "H = -(1/r + cos(v)/l)/2\n",
	  { { "R", 2, 0.01, 100 }, { "r", 0.8, 0.001, 100 }, { "angle", 100, 1, 350 },
	    { "v0", -70, -175, 175 }, { "v1", 120, -175, 175 } },
	  torus_domain, torus_phi, torus_lambda, torus_H, NULL },
	{ "enneper",
	  "a (x - x^3/3 + x y^2, y - y^3/3 + x^2 y, x^2 - y^2), r <= rho;\n"
	  "lambda = a (1+r^2), H = 0, T = 1\n",
	  { { "a", 1, 0.001, 1000 }, { "rho", 0.9, 0.01, 1.7 } },
	  enneper_domain, enneper_phi, enneper_lambda, zero, NULL },
	{ NULL, NULL, { { NULL, 0, 0, 0 } }, NULL, NULL, NULL, NULL, NULL }
};
