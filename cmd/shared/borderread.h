/* borderread.h - the boundary curve of a grid of either kind. */
#ifndef CMD_BORDERREAD_H
#define CMD_BORDERREAD_H

#include "../../lib/grid/border.h"
#include "cmd.h"

/* The border of x y z, or where there is no x of band.x band.y band.z, measured; or die. */
void border_read(const CmdInput *in, const Lhg *g, Border *b);

#endif
