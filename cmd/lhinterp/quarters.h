/* quarters.h - whether a grid should be turned before it is compared with another. */
#ifndef CMD_QUARTERS_H
#define CMD_QUARTERS_H

#include "../../lib/grid/border.h"
#include "../shared/cmd.h"

/* Notes if the border of B fits that of A clearly better with another corner first.  Borders are
 * compared at equal conformal position, scaled to one size, B moved rigidly.  aligned: B will be
 * moved; otherwise turns of the corners that need a large rotation are excluded. */
void quarters_check(const CmdInput *A, const Border *a, const CmdInput *B, const Border *b,
	int aligned);

#endif
