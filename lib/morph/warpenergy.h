/* warpenergy.h - the function of the coefficients of a map that warp.h minimises. */
#ifndef WARPENERGY_H
#define WARPENERGY_H

#include "warp.h"
#include "warpdistortion.h"
#include "warpmodes.h"

typedef struct WarpEnergy {
	int    nu, nv, M;
	double T, alpha, beta;
	const double *a, *b;            /* [nv][nu][3] smoothed images; NULL: none */
	WarpMarks marks;
	WarpModes modes;
	WarpDistortion distortion;
	double *f, *g, *row;            /* [2][nv][nu] the map and derivatives by it; [nv] */
} WarpEnergy;

/* Prepares nu x nv nodes and M modes; the caller sets the rest.  Returns 0, or WARP_ENOMEM with
 * nothing to free. */
int  warpenergy_init(WarpEnergy *e, int nu, int nv, double T, int M);
void warpenergy_free(WarpEnergy *e);

/* Sets e->f to the map of the coefficients x[2][M][M]. */
void warpenergy_map(const WarpEnergy *e, const double *x);

/* The energy, and its gradient; warpminimise.h lowers it. */
double warpenergy(void *ctx, const double *x, double *grad);

#endif
