/* surfacefit.h - a grid's channels to the surface method of lib/surface.h, and its troubles
 * to a person. */
#ifndef SURFACEFIT_H
#define SURFACEFIT_H

#include "../shared/cmd.h"

typedef struct SurfaceFit {
	double  tolerance;
	int     steps, no_start, ideal, free;
	double *forecast, *detail;      /* of lib/surface.h, or NULL */
} SurfaceFit;

/* Rings of band that are needed: all but one are for a start, and that one for a boundary
 * that is held; one that is free is placed by it where there is a band. */
int surfacefit_rings(const Lhg *g, const SurfaceFit *o);

/* phi[3][nv][nu] has those rings, and becomes the surface; dies if there is none. */
void surfacefit(const CmdInput *in, const Lhg *g, const SurfaceFit *o, double *phi);

#endif
