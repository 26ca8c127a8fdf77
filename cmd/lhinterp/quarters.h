/* quarters.h - whether a grid should be turned before it is compared with another. */
#ifndef CMD_QUARTERS_H
#define CMD_QUARTERS_H

#include "../../lib/grid/border.h"
#include "../shared/cmd.h"

/* Notes if the border of B would fit that of A clearly better with its corners a quarter
 * turn or more on: at equal conformal position, both of one size, B moved rigidly.  If it is not to
 * be so moved (aligned), turns of the corners that would want it do not count. */
void quarters_check(const CmdInput *A, const Border *a, const CmdInput *B, const Border *b,
	int aligned);

#endif
