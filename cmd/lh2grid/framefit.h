/* framefit.h - calls the frame method (lib/surface/frame.h) for a grid; dies if it fails. */
#ifndef FRAMEFIT_H
#define FRAMEFIT_H

#include "../../lib/base/chart.h"
#include "../shared/cmd.h"

/* Completes phi[3][nv][nu]: on entry it holds the positions of the FRAME_BAND outer rings, on return
 * those of all nodes.  Dies if the method fails. */
void framefit(const CmdInput *in, Chart g, const double *lambda, const double *H, double *phi);

#endif
