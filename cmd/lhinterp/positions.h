/* positions.h - the channels of a grid that hold positions: x y z and NAME.x NAME.y NAME.z, if
 * their unit is "length". */
#ifndef CMD_POSITIONS_H
#define CMD_POSITIONS_H

#include "../../lib/base/procrustes.h"
#include "../shared/cmd.h"

/* Move the positions in all these channels by r. */
void positions_move(Lhg *g, const Rigid *r);

/* Add displacements to the positions in all these channels.  d[n][3] are the displacements of the
 * border nodes, in the order of border.h; coons.h interpolates them over the grid. */
void positions_shift(Lhg *g, const double *d);

#endif
