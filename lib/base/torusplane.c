/* torusplane.c - theta series. */
#include <math.h>

#include "torusplane.h"

enum { MOST = 40 };             /* terms: q^(n^2) < 1e-40 from n = 28 on at the least tau */
static const double TINY = 1e-18;

/* Both series at zeta = u + tau v, |v| <= 1/4, where no term of index n > 0 exceeds q^(n^2-n). */
static void
thetas(double complex tau, double u, double v, double complex *theta1, double complex *theta4)
{
	double complex x = 2*M_PI*(u + tau*v - 0.25), L = 2*M_PI*I*tau, add, more;
	int n;

	*theta1 = 0;
	*theta4 = 1;
	for (n = 0; n < MOST; n++) {
		add = I*(cexp(L*(n + .5)*(n + .5) - I*(2*n + 1)*x) - cexp(L*(n + .5)*(n + .5) + I*(2*n + 1)*x));
		more = n ? cexp(L*n*n + 2*I*n*x) + cexp(L*n*n - 2*I*n*x) : 0;
		*theta1 += n%2 ? -add : add;
		*theta4 += n%2 ? -more : more;
		if (n > 0 && cabs(add) < TINY*cabs(*theta1) && cabs(more) < TINY)
			break;
	}
}

void
torusplane_z(double complex tau, double u, double v, double complex Z[2])
{
	int far;

	v -= floor(v + 0.25);           /* to -1/4 .. 3/4 */
	far = v > 0.25;
	thetas(tau, u, far ? v - 0.5 : v, &Z[far], &Z[!far]);
}

double complex
torusplane_cone(double complex tau)
{
	double complex L = 2*M_PI*I*tau, theta2 = 0, theta3 = 1;
	int n;

	for (n = 0; n < MOST; n++) {
		theta2 += 2*cexp(L*(n + .5)*(n + .5));
		theta3 += n ? 2*cexp(L*n*n) : 0;
	}
	return theta2/theta3;
}
