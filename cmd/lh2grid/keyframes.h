/* keyframes.h - frames between two others begin with what those two found.
 *
 * Every so-manieth frame of a stream is solved by itself.  What its finest grid added to its
 * coarse ones, the detail, changes little on the way to the next of them: the frames between
 * begin there with both details in proportion.  Each still has its own start and coarse
 * grids, so that nothing is handed on from frame to frame.
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
