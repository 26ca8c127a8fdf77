/* gridfit.h - the surface of one grid, by either method. */
#ifndef GRIDFIT_H
#define GRIDFIT_H

#include "surfacefit.h"

enum { GRIDFIT_SURFACE, GRIDFIT_FRAME };        /* the words of --method in their order */

/* Replaces the channels of g by its surface, or dies.  Returns that surface, [3][nv][nu], to be freed.
 * follows: --follow, which needs more memory. */
double *gridfit(const CmdInput *in, Lhg *g, int method, int follows, const SurfaceFit *o);

#endif
