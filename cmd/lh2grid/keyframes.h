/* keyframes.h - frames between two key frames start from the interpolated detail of both.
 *
 * Every N-th frame of a stream is solved by itself.  Its detail, the finest result minus the
 * surface of the coarser grid, changes little up to the next key frame.  The frames between add
 * the linear interpolation of both details on their finest grid.  Each still has its own start
 * and coarse grids, so that errors do not pass from frame to frame.  doc/mathematics.md 8.5.
 */
#ifndef KEYFRAMES_H
#define KEYFRAMES_H

#include "surfacefit.h"

enum { KEYFRAMES_MOST = 1000 };

/* Turns a grid into its surface. */
typedef void KeyframesConvert(const CmdInput *in, Lhg *g, const SurfaceFit *o);

/* Converts and writes all grids of in; every: 2 .. KEYFRAMES_MOST. */
void keyframes(CmdInput *in, int every, const SurfaceFit *o, KeyframesConvert *convert);

#endif
