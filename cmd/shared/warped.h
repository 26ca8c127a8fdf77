/* warped.h - grids that were brought to the chart of another (metadatum warped, format/LHG.md). */
#ifndef CMD_WARPED_H
#define CMD_WARPED_H

#include "../../format/lhg.h"

/* What H is on a warped grid; NULL if g is not warped. */
const char *warped_H(const Lhg *g);

#endif
