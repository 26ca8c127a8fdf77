/* sampled.h - B on the chart of A. */
#ifndef CMD_SAMPLED_H
#define CMD_SAMPLED_H

#include "find.h"

/* Sets out to b sampled at the images of a's nodes: positions from b's mesh if it has one, else from its grid,
 * other channels from its grid; then moved rigidly onto a.  out has a's size and height, b's metadata and
 * history, and says how it was warped. */
void sampled(const Side *a, const Side *b, const Found *f, Lhg *out);

#endif
