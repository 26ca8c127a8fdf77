/* lhchannels.h - the channels that grid2lh writes. */
#ifndef CMD_LHCHANNELS_H
#define CMD_LHCHANNELS_H

#include "../shared/cmd.h"

/* Replaces the channels x y z of g by lambda, H, band and start, or dies.
 *
 * curvature  LAMBDAH_NORMAL or LAMBDAH_MAGNITUDE (lib/grid/lambdah.h)
 * lattice    about this many nodes of start along the shorter side; 0: no start
 * place      also add the positions as place
 * residual   also add nu1 nu2 tau1 tau2 */
void lhchannels(const CmdInput *in, Lhg *g, int curvature, int lattice, int place, int residual);

#endif
