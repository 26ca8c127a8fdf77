/* synth_relief.c - face, tooth and cortex.  The numbers were chosen by eye. */
#include <math.h>

#include "rng.h"
#include "synth_shapes.h"

static const double TURN = 6.283185307179586;

/* A bump h high at (cx,cy), sx and sy wide; with pair, a second one mirrored in x = 0. */
typedef struct Bump {
	double cx, cy, sx, sy, h;
	int    pair;
} Bump;

static double
gauss(double x, double y, const Bump *b, double cx)
{
	double u = (x - cx)/b->sx, v = (y - b->cy)/b->sy;

	return b->h*exp(-(u*u + v*v)/2);
}

static double
relief(const Bump *b, int n, double x, double y)
{
	double z = 0;

	for (; n > 0; n--, b++) {
		z += gauss(x, y, b, b->cx);
		if (b->pair)
			z += gauss(x, y, b, -b->cx);
	}
	return z;
}

static void
face_domain(const double *p, SynthDomain *d)
{
	d->shape = SYNTH_OVAL;
	d->x1 = 7*p[0], d->x0 = -d->x1;
	d->y1 = 9.5*p[0], d->y0 = -d->y1;
}

/* An ellipsoid under the bumps; centimetres at size 1. */
static void
face_phi(const double *p, double x, double y, double xyz[3])
{
	static const Bump rest[] = {
		{ 3.0, 2.0, 1.35, 0.95, -1.5, 1 },      /* eye sockets */
		{ 3.05, 1.85, 0.85, 0.5, 0.95, 1 },     /* eyeballs */
		{ 2.7, 3.6, 1.8, 0.6, 0.45, 1 },        /* brows */
		{ 4.0, -0.9, 1.6, 1.4, 0.55, 1 },       /* cheeks */
		{ 6.3, 3.2, 1.2, 2.2, -0.5, 1 },        /* temples */
		{ 0, 6.2, 3.6, 2.4, 0.5, 0 },           /* forehead */
		{ 0, -3.2, 0.28, 0.45, -0.12, 0 },      /* philtrum */
		{ 0, -6.4, 1.1, 0.45, -0.35, 0 },       /* fold below the lip */
		{ 0, -7.8, 1.3, 0.9, 0.9, 0 },          /* chin */
	};
	static const Bump nose[] = {
		{ 0, 1.2, 0.6, 2.0, 1.3, 0 },           /* bridge */
		{ 0, -1.2, 0.85, 0.85, 1.9, 0 },        /* tip */
		{ 1.15, -1.55, 0.5, 0.5, 0.8, 1 },      /* wings */
	};
	static const Bump mouth[] = {
		{ 0, -4.25, 1.25, 0.33, 0.6, 0 },       /* upper lip */
		{ 0, -5.3, 1.05, 0.4, 0.65, 0 },        /* lower lip */
		{ 0, -4.75, 1.25, 0.17, -0.4, 0 },      /* between them */
	};
	double u = x/p[0], v = y/p[0], z;

	z = 9*sqrt(1 - u*u/81 - v*v/169) - 5.5;
	z += relief(rest, sizeof rest/sizeof *rest, u, v);
	z += p[1]*relief(nose, sizeof nose/sizeof *nose, u, v);
	z += relief(mouth, sizeof mouth/sizeof *mouth, u, v - 0.14*p[2]*u*u);
	xyz[0] = x;
	xyz[1] = y;
	xyz[2] = p[0]*z;
}

/* Stereographic coordinates of a ball, from its top down to 12 degrees below the equator. */
static void
tooth_domain(const double *p, SynthDomain *d)
{
	(void)p;
	d->shape = SYNTH_OVAL;
	d->x1 = d->y1 = tan(102./360*TURN/2);
	d->x0 = d->y0 = -d->x1;
}

static double
tooth_scale(const double *p, double x, double y)
{
	return 10*p[0]/(1 + x*x + y*y);
}

/* A rounded box |X/5.3|^4 + |Y/4.7|^4 + |Z/3.6|^4 = 1, its lid carved with cusps, pits
 * and fissures; millimetres at size 1. */
static void
tooth_phi(const double *p, double x, double y, double xyz[3])
{
	static const Bump four[] = {
		{ 2.6, 2.3, 1.05, 1.0, 1.7, 0 },        /* mesiobuccal */
		{ -2.3, 2.3, 1.05, 1.0, 1.5, 0 },       /* distobuccal */
		{ 2.3, -2.2, 1.1, 1.05, 1.9, 0 },       /* mesiolingual */
		{ -2.5, -2.2, 1.0, 1.0, 1.6, 0 },       /* distolingual */
		{ 0.2, 0, 1.5, 1.2, -0.9, 0 },          /* basin */
	};
	static const Bump fifth[] = { { -4.1, 0.2, 0.7, 0.8, 1.2, 0 } };
	double q = 1 + x*x + y*y, a = 2*x/q, b = 2*y/q, c = 2/q - 1, r, X, Y, Z, lid, groove;

	r = pow(a*a*a*a + b*b*b*b + c*c*c*c, -0.25);
	X = 5.3*r*a;
	Y = 4.7*r*b;
	Z = 3.6*r*c;
	lid = c > 0 ? exp(-0.02*pow(X*X/14 + Y*Y/11, 4))*c*c/(c*c + 0.08) : 0;
	groove = 0.75*exp(-pow(Y - 0.35*sin(1.3*X), 2)/0.12)
		+ 0.6*exp(-pow(X - 0.3 + 0.25*Y, 2)/0.12);
	groove *= exp(-pow(X*X + Y*Y, 2)/250);
	Z += lid*(relief(four, sizeof four/sizeof *four, X, Y) - groove);
	if (p[1] > 4.5)
		Z += lid*relief(fifth, 1, X, Y);
	xyz[0] = p[0]*X;
	xyz[1] = p[0]*Y;
	xyz[2] = p[0]*Z;
}

static void
cortex_domain(const double *p, SynthDomain *d)
{
	d->shape = SYNTH_RECT;
	d->x1 = p[0]/2, d->x0 = -d->x1;
	d->y1 = 0.4*p[0], d->y0 = -d->y1;
}

/* Waves of about the same length in random directions add up to a field f without preferred
 * places.  The zero lines of f wander and join, and along them the sheet is pressed down. */
static void
cortex_phi(const double *p, double x, double y, double xyz[3])
{
	enum { WAVES = 24 };
	const double width = 0.32;      /* of a sulcus, in units of f */
	uint64_t rng = (uint64_t)p[3];
	double f = 0, a, k, phase;
	int i;

	for (i = 0; i < WAVES; i++) {
		a = TURN*rng_unit(&rng);
		k = TURN/(2*p[2])*(0.75 + 0.5*rng_unit(&rng));
		phase = TURN*rng_unit(&rng);
		f += cos(k*(x*cos(a) + y*sin(a)) + phase);
	}
	f *= sqrt(2./WAVES);
	xyz[0] = x;
	xyz[1] = y;
	xyz[2] = -p[1]*exp(-f*f/(2*width*width)) + 0.35*p[1]*(1 - exp(-f*f))
		- (x*x + y*y)/(1.5*p[0]);
}

const SynthKind synth_reliefs[] = {
	{ "face",
	  "an ellipsoid with gaussian bumps for brow, eyes, nose, cheeks, lips, chin: a height\n"
	  "over an oval 14 x 19 times size; nose scales the nose, smile lifts the lips' ends\n",
	  { { "size", 1, 0.001, 1000 }, { "nose", 1, 0, 1.3 }, { "smile", 0, -0.5, 1 } },
	  face_domain, face_phi, NULL, NULL, NULL },
	{ "tooth",
	  "a molar's crown: a rounded box 10.6 x 9.4 times size, from stereographic\n"
	  "coordinates of the ball to 12 degrees below its equator, with cusps and fissures\n",
	  { { "size", 1, 0.001, 1000 }, { "cusps", 5, 4, 5 } },
	  tooth_domain, tooth_phi, NULL, NULL, tooth_scale },
	{ "cortex",
	  "a sheet size x 0.8 size, bent, with sulci depth deep and about width apart along\n"
	  "the zero lines of a random sum of waves; another pattern, other sulci\n",
	  { { "size", 10, 1, 1000 }, { "depth", 0.6, 0, 100 }, { "width", 1.2, 0.1, 1000 },
	    { "pattern", 1, 0, 1e9 } },
	  cortex_domain, cortex_phi, NULL, NULL, NULL },
	{ NULL, NULL, { { NULL, 0, 0, 0 } }, NULL, NULL, NULL, NULL, NULL }
};
