/* channels.h - the band that lh2grid reads and the positions that it writes. */
#ifndef CHANNELS_H
#define CHANNELS_H

#include "../shared/cmd.h"

/* Copies the nodes of the outer `rings` rings from band.x band.y band.z to phi[3][nv][nu].  Dies if
 * the band has fewer rings. */
void band_read(const CmdInput *in, const Lhg *g, int rings, double *phi);

/* Adds x y z from phi [3][nv][nu] and removes all channels that lh2grid reads. */
void surface_replace(const CmdInput *in, Lhg *g, const double *phi);

#endif
