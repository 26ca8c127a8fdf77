/* positions.h - the channels of a grid that hold positions: x y z, and NAME.x NAME.y NAME.z in
 * the unit length. */
#ifndef CMD_POSITIONS_H
#define CMD_POSITIONS_H

#include "../../lib/base/procrustes.h"
#include "../shared/cmd.h"

/* Move all of them. */
void positions_move(Lhg *g, const Rigid *r);

/* Add to all of them displacements that are given on the border, d[n][3] in the order of
 * border.h, and continued over the grid by coons.h. */
void positions_shift(Lhg *g, const double *d);

#endif
