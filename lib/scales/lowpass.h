/* lowpass.h - a low-pass filter of order 3 in the metric of a surface (doc/mathematics.md 5.5).
 *
 * A wave of wave number k on the surface is multiplied by 1/(1 + (s k)^6).  With K and M of
 * multigrid.h, M having the density lambda^2, M^-1 K is minus the Laplacian of the surface, and the
 * filtered field f~ is the solution of
 *
 *   (M + s^6 K M^-1 K M^-1 K) f~ = M f.
 *
 * An open side of the chart is free, which mirrors f there, or held; then f must be 0 on it.
 */
#ifndef LOWPASS_H
#define LOWPASS_H

#include "../poisson/multigrid.h"

enum { LOWPASS_ENOMEM = -1, LOWPASS_WORK = 5 };

typedef struct Lowpass {
	Chart     g;
	Multigrid grid;
	double    unit;                 /* root mean square of lambda: the unit of length here */
	double   *work[LOWPASS_WORK];
} Lowpass;

/* lambda > 0 is raised to at least a thousandth of its root mean square.  Returns 0 or
 * LOWPASS_ENOMEM; p then holds nothing to free. */
int  lowpass_init(Lowpass *p, Chart g, int held, const double *lambda);
void lowpass_free(Lowpass *p);

/* The square root of the area of the surface.  p must have free sides. */
double lowpass_root_area(const Lowpass *p);

/* Filters f[nv][nu] in place; s > 0 is a length, in the unit of lambda. */
void lowpass(Lowpass *p, double s, double *f);

/* One implicit step of the heat flow on the surface, in place: (M + (s^2/2) K) f~ = M f. */
void lowpass_heat(Lowpass *p, double s, double *f);

#endif
