/* frameband.h - frame and second fundamental form of a given surface.  Private to frame. */
#ifndef FRAMEBAND_H
#define FRAMEBAND_H

#include "../base/chart.h"

/* phi_u, phi_v and n in pqn, (L - N)/2 and M in DM, at the place (x,y) among the inner nodes of g, linear
 * between nodes: so they are the same from the mirrored surface, which a nearest node is not.  *at is a
 * node there.  Returns 0 or FRAME_EBAND. */
int frameband(Chart g, const double *const phi[3], double x, double y, int *at, double pqn[9], double DM[2]);

#endif
