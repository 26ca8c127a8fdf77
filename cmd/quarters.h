/* quarters.h - whether a grid should be turned before it is compared with another. */
#ifndef CMD_QUARTERS_H
#define CMD_QUARTERS_H

#include "../lib/border.h"
#include "cmd.h"

/* Notes if the border of B would fit that of A clearly better with its corners a quarter
 * turn or more on: moved rigidly at equal conformal position, both of one size. */
void quarters_check(const CmdInput *A, const Border *a, const CmdInput *B, const Border *b);

#endif
