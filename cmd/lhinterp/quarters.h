/* quarters.h - whether another corner of a border should come first to fit another border. */
#ifndef CMD_QUARTERS_H
#define CMD_QUARTERS_H

#include "../../lib/grid/border.h"
#include "../shared/cmd.h"

/* Prints a note if the border of B fits that of A clearly better with another corner first.  The
 * borders are compared at equal places (border.h), after both are scaled to the same size and B is
 * moved rigidly onto A.  aligned: B will be moved for the morph, too; otherwise corners that need a
 * large rotation are excluded. */
void quarters_check(const CmdInput *A, const Border *a, const CmdInput *B, const Border *b,
	int aligned);

#endif
