/* gridfit.h - the surface of one grid, by either method. */
#ifndef GRIDFIT_H
#define GRIDFIT_H

#include "surfacefit.h"

enum { GRIDFIT_SURFACE, GRIDFIT_FRAME };        /* in the order of the words of --method */

/* Replaces the channels of g by its surface, or dies.  Returns that surface, [3][nv][nu], to be
 * freed.  follows: whether --follow is given, which needs more memory. */
double *gridfit(const CmdInput *in, Lhg *g, int method, int follows, const SurfaceFit *o);

#endif
