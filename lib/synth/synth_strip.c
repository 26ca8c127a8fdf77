/* synth_strip.c - the strips of the paper's first experiment. */
#include <math.h>

#include "synth_shapes.h"

static const double DEG = 3.14159265358979323846/180;

/* Arc length of the spiral r = a t from its centre. */
static double
spiral_s(double a, double t)
{
	return a/2*(t*sqrt(1 + t*t) + asinh(t));
}

/* The inverse of spiral_s, by Newton's method.  spiral_s is convex in t, so from a start above the
 * result the iterates descend to it. */
static double
spiral_t(double a, double s)
{
	double t = sqrt(2*s/a), step;
	int i;

	for (i = 0; i < 50; i++) {
		step = (spiral_s(a, t) - s)/(a*sqrt(1 + t*t));
		t -= step;
		if (!(fabs(step) > 1e-15*t))
			break;
	}
	return t;
}

/* The strip lies on the cylinder over the spiral, which unrolls to the (s,z) plane.  There the strip
 * is a rectangle, turned by the rise.  Its upper left corner is at the start r = r0 of the spiral,
 * its lower right corner at the end. */
static void
spiral_place(const double *p, double x, double y, double *s, double *z)
{
	double c = cos(DEG*p[4]), d = sin(DEG*p[4]);

	*s = spiral_s(p[1], p[0]/p[1]) + p[3]*d + x*c - y*d;
	*z = x*d + y*c;
}

static void
spiral_domain(const double *p, SynthDomain *d)
{
	double t0 = p[0]/p[1], t1 = t0 + 360*DEG*p[2];

	d->shape = SYNTH_RECT;
	d->x1 = (spiral_s(p[1], t1) - spiral_s(p[1], t0) - p[3]*sin(DEG*p[4]))/cos(DEG*p[4]);
	d->y1 = p[3];
}

static void
spiral_phi(const double *p, double x, double y, double xyz[3])
{
	double s, z, t;

	spiral_place(p, x, y, &s, &z);
	t = spiral_t(p[1], s);
	xyz[0] = p[1]*t*cos(t);
	xyz[1] = p[1]*t*sin(t);
	xyz[2] = z;
}

static double
spiral_lambda(const double *p, double x, double y)
{
	(void)p, (void)x, (void)y;
	return 1;
}

/* Minus half the curvature of the spiral. */
static double
spiral_H(const double *p, double x, double y)
{
	double s, z, t;

	spiral_place(p, x, y, &s, &z);
	t = spiral_t(p[1], s);
	return -(2 + t*t)/(2*p[1]*pow(1 + t*t, 1.5));
}

static void
moebius_domain(const double *p, SynthDomain *d)
{
	d->shape = SYNTH_RECT;
	d->x1 = p[0]*DEG*p[2];
	d->y0 = -p[1]/2;
	d->y1 = p[1]/2;
}

static void
moebius_phi(const double *p, double x, double y, double xyz[3])
{
	double t = x/p[0], l = p[0] + y*cos(t/2);

	xyz[0] = l*cos(t);
	xyz[1] = l*sin(t);
	xyz[2] = y*sin(t/2);
}

const SynthKind synth_strips[] = {
	{ "spiral",
	  "a strip rolled up without stretching: with s, z = (x,y) turned by rise and moved,\n"
	  "(r cos t, r sin t, z), r = gap t, where s = gap (t sqrt(1+t^2) + asinh t)/2 is the\n"
	  "arc length of the spiral from r = r0 over so many turns; 0 <= y <= width;\n"
	  "lambda = 1, H = -(2+t^2)/(2 gap (1+t^2)^1.5)\n",
	  { { "r0", 0.57, 0.01, 100 }, { "gap", 0.18, 0.01, 10 }, { "turns", 3.2, 0.1, 20 },
	    { "width", 1.7, 0.01, 100 }, { "rise", 1, 0, 45 } },
	  spiral_domain, spiral_phi, spiral_lambda, spiral_H, NULL },
	{ "moebius",
	  "(l cos t, l sin t, y sin(t/2)), l = R + y cos(t/2), t = x/R to angle,\n"
	  "|y| <= width/2: part of a Moebius strip; not conformal\n",
	  { { "R", 2, 0.01, 100 }, { "width", 1.4, 0.001, 100 }, { "angle", 280, 1, 355 } },
	  moebius_domain, moebius_phi, NULL, NULL, NULL },
	{ NULL, NULL, { { NULL, 0, 0, 0 } }, NULL, NULL, NULL, NULL, NULL }
};
