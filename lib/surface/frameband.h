/* frameband.h - frame and second fundamental form of a given surface.  Private to frame. */
#ifndef FRAMEBAND_H
#define FRAMEBAND_H

#include "../base/chart.h"

/* Sets pqn to phi_u, phi_v and n, and DM to (L - N)/2 and M, at (x,y), in grid steps, among the inner
 * nodes of g.  They are bilinear between nodes, so that a mirrored surface gives the mirrored result;
 * with the nearest node it would not where two are equally near.  *at is a node beside (x,y).  Returns
 * 0, or FRAME_EBAND if there is no tangent plane at *at. */
int frameband(Chart g, const double *const phi[3], double x, double y, int *at, double pqn[9], double DM[2]);

#endif
