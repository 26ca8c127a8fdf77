/* framefit.h - calls the frame method (lib/surface/frame.h) for a grid; failures become messages. */
#ifndef FRAMEFIT_H
#define FRAMEFIT_H

#include "../../lib/base/chart.h"
#include "../shared/cmd.h"

/* phi [3][nv][nu] has the FRAME_BAND outer rings, and becomes the surface; dies if there is none. */
void framefit(const CmdInput *in, Chart g, const double *lambda, const double *H, double *phi);

#endif
