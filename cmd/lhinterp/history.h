/* history.h - the past of a grid that has two parents. */
#ifndef CMD_HISTORY_H
#define CMD_HISTORY_H

#include "../../format/lhg.h"

/* g gets the steps of a, each marked "A: ", then those of b, marked "B: ", and the data
 * of the metadata that are equal in both; or dies for want of memory. */
void history_merge(const Lhg *a, const Lhg *b, Lhg *g);

#endif
