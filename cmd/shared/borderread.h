/* borderread.h - the boundary curve of a grid with x y z or band. */
#ifndef CMD_BORDERREAD_H
#define CMD_BORDERREAD_H

#include "../../lib/grid/border.h"
#include "cmd.h"

/* The border from x y z, or if there is no x from band.x band.y band.z, with its arc lengths; or
 * die. */
void border_read(const CmdInput *in, const Lhg *g, Border *b);

#endif
