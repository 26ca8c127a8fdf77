/* merge.h - metadata and history of a grid that is made of two. */
#ifndef CMD_MERGE_H
#define CMD_MERGE_H

#include "../../format/lhg.h"

/* Adds to g the metadata that a and b have in common, and the steps of a, each marked "A: ", then
 * those of b, marked "B: "; or dies if memory runs out. */
void merge_text(const Lhg *a, const Lhg *b, Lhg *g);

#endif
