/* surfacefit.h - a grid's channels to the surface method of lib/surface.h, and its troubles
 * to a person. */
#ifndef SURFACEFIT_H
#define SURFACEFIT_H

#include "cmd.h"

typedef struct SurfaceFit {
	double tolerance;
	int    steps, no_start, ideal;
} SurfaceFit;

/* Rings of band that are needed: all but one are for a start. */
int surfacefit_rings(const Lhg *g, const SurfaceFit *o);

/* phi[3][nv][nu] has the band, and becomes the surface; dies if there is none. */
void surfacefit(const CmdInput *in, const Lhg *g, const SurfaceFit *o, double *phi);

#endif
