/* surfacefit.h - calls the surface method (lib/surface/surface.h) for a grid; dies if it fails. */
#ifndef SURFACEFIT_H
#define SURFACEFIT_H

#include "../../lib/surface/fit.h"
#include "../shared/cmd.h"

#define SURFACEFIT_TOLERANCE 5e-5       /* by default */

typedef struct SurfaceFit {
	double  tolerance;
	int     steps, no_start, no_place, ideal, free;
	int     follows;                /* the start channels are of another frame */
	const double *where;            /* closed surfaces: [3][nv][nu], what places the result in place of
	                                 * the start, or NULL */
	double *forecast, *detail;      /* of lib/surface/surface.h, or NULL */
} SurfaceFit;

/* The number of rings of the band that are needed: 3 if the frame method must provide the start;
 * else 1 for a held boundary (or to place a free one), and 0 for a free boundary without a band. */
int surfacefit_rings(const Lhg *g, const SurfaceFit *o);

/* Completes phi[3][nv][nu]: on entry it holds the rings of surfacefit_rings, on return all nodes.  Dies
 * if no surface is found.  at: out, how the steps ended; surfacefit_meta writes it into the metadata. */
void surfacefit(const CmdInput *in, const Lhg *g, const SurfaceFit *o, double *phi, FitProgress *at);
void surfacefit_meta(Lhg *g, const FitProgress *at);

#endif
