/* borderread.h - the boundary curve of a grid with x y z or band. */
#ifndef CMD_BORDERREAD_H
#define CMD_BORDERREAD_H

#include "../../lib/grid/border.h"
#include "cmd.h"

/* Sets b to the boundary curve of g, with its arc lengths: from x y z, or from band.x band.y band.z
 * if there is no x.  Dies if a channel is missing or the curve has no length. */
void border_read(const CmdInput *in, const Lhg *g, Border *b);

#endif
