/* sockplane.c - the sock's map by theta functions, and its inverse by Carlson's R_F. */
#include <float.h>
#include <math.h>

#include "sockplane.h"

enum {
	ROUNDS = 60,            /* the means converge quadratically, so this is never reached */
	TERMS = 6               /* the next term is below e^-90 of the largest */
};

static double
agm(double a, double b)
{
	double t;
	int i;

	for (i = 0; i < ROUNDS && fabs(a - b) > DBL_EPSILON*a; i++)
		t = (a + b)/2, b = sqrt(a*b), a = t;
	return (a + b)/2;
}

double
sockplane_height(double rho)
{
	return agm(1, sqrt((1 - rho)*(1 + rho)))/(4*agm(1, rho));
}

/* Jacobi's theta functions at x, of the nome e^L with L <= -pi and |Im x| <= -L/4, up to a common
 * factor, which keeps them finite.  doc/mathematics.md 3.8. */
typedef struct Theta {
	double complex t1, t2, t3, t4;
} Theta;

static Theta
theta(double complex x, double L)
{
	Theta f = { 0, 0, 0, 0 };
	double lower = -fabs(cimag(x)), sign = 1, exponent;
	double complex up, down;
	int n;

	for (n = 0; n < TERMS; n++) {
		exponent = (n + 0.5)*(n + 0.5)*L + lower;
		up = cexp(exponent + I*(2*n + 1)*x);
		down = cexp(exponent - I*(2*n + 1)*x);
		f.t1 += sign*(up - down)/I;
		f.t2 += up + down;
		exponent = n*n*L + lower;
		up = cexp(exponent + I*2*n*x);
		down = n ? cexp(exponent - I*2*n*x) : 0;
		f.t3 += up + down;
		f.t4 += sign*(up + down);
		sign = -sign;
	}
	return f;
}

/* The theta functions at (u,v): where T < 1/8, after Jacobi's transformation of the nome, which
 * exchanges t2 and t4. */
static Theta
theta_at(const SockPlane *p, double u, double v)
{
	double complex x;
	Theta f;

	u -= floor(u);
	if (u > 0.5)
		u = 1 - u, v = -v;
	x = 2*M_PI*(u - 0.25 + I*v);
	if (p->T >= 0.125)
		return theta(x, p->L);
	f = theta(x/(8*I*p->T), p->L);
	return (Theta){ I*f.t1, f.t4, f.t3, f.t2 };
}

SockPlane
sockplane(double T)
{
	SockPlane p = { .T = T };
	double factor = T < 0.125 ? 1/(8*T) : 1, t2, t3, t4;
	Theta f;

	p.L = T < 0.125 ? -M_PI/(8*T) : -M_PI*8*T;
	f = theta(0, p.L);
	t2 = creal(T < 0.125 ? f.t4 : f.t2), t3 = creal(f.t3), t4 = creal(T < 0.125 ? f.t2 : f.t4);
	p.s = t2/t3;
	p.K = M_PI_2*factor*t3*t3;
	p.factor = 2*M_PI*factor*t4*t4;
	return p;
}

double complex
sockplane_z(const SockPlane *p, double u, double v)
{
	Theta f = theta_at(p, u, v);

	return f.t1/f.t4;
}

double
sockplane_stretch(const SockPlane *p, double u, double v)
{
	Theta f = theta_at(p, u, v);

	return p->factor*cabs(f.t2/f.t4)*cabs(f.t3/f.t4);
}

double
sockplane_round(const SockPlane *p, double u, double v)
{
	double r = cabs(sockplane_z(p, u, v));

	return 2*sockplane_stretch(p, u, v)/(1 + r*r);
}

/* Carlson's R_F(x, y, 1). */
static double complex
carlson(double complex x, double complex y)
{
	double complex z = 1, root[3], lambda, mean, X, Y, e2, e3;
	int i;

	for (i = 0; i < ROUNDS; i++) {
		mean = (x + y + z)/3;
		if (fmax(cabs(mean - x), fmax(cabs(mean - y), cabs(mean - z))) < 1e-3*cabs(mean))
			break;
		root[0] = csqrt(x), root[1] = csqrt(y), root[2] = csqrt(z);
		lambda = root[0]*root[1] + root[0]*root[2] + root[1]*root[2];
		x = (x + lambda)/4, y = (y + lambda)/4, z = (z + lambda)/4;
	}
	X = (mean - x)/mean, Y = (mean - y)/mean;
	e2 = X*Y - (X + Y)*(X + Y);
	e3 = -X*Y*(X + Y);
	return (1 - e2/10 + e3/14 + e2*e2/24 - 3*e2*e3/44)/csqrt(mean);
}

/* 1 - w^2 for Im w >= 0.  The sign of its imaginary part, even of 0, chooses the side of the cut of the square
 * root. */
static double complex
one_less_square(double complex w)
{
	double x = creal(w), y = cimag(w);

	return CMPLX((1 - x)*(1 + x) + y*y, -2*x*y);
}

void
sockplane_uv(const SockPlane *p, double complex z, double *u, double *v)
{
	int up = cimag(z) >= 0;
	double complex w, F;
	double x;

	z = CMPLX(creal(z), fabs(cimag(z)));    /* also of -0, which is on the wrong side of cuts */
	w = z/p->s;
	F = w*carlson(one_less_square(w), one_less_square(p->s*z));
	x = up ? creal(F) : 2*p->K - creal(F);

	*u = (x/p->K + 1)/4;
	*u -= floor(*u);
	*v = fmin(fmax(fabs(cimag(F))/(4*p->K), 0), p->T);
}
