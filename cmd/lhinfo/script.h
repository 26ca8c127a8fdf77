/* script.h - the history of a grid as a script for a shell. */
#ifndef CMD_SCRIPT_H
#define CMD_SCRIPT_H

#include <stdio.h>

#include "../../format/lhg.h"

/* Writes to f the commands that make the set of g again, on their stdout: a pipeline; for a merge
 * (LHG.md 2.4) first one for each input, into a temporary folder.  An operand that a step read its
 * grid from is left out, since the grid comes from the step before.  *folder: whether the folder
 * exists already, for the first grid 0.  Dies if g has no history, or if steps of it are missing. */
void script_write(FILE *f, const char *name, const Lhg *g, int *folder);

#endif
