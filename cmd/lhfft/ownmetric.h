/* ownmetric.h - the filters of lhfft that act in the metric of the surface: --scale and --relief. */
#ifndef CMD_OWNMETRIC_H
#define CMD_OWNMETRIC_H

#include "scales.h"

/* Filter lambda, H and the place of g, if it has one, as at scale k, or die.  Set the metadata scale,
 * waves and, for --relief, relief.  before: of the input. */
void ownmetric_apply(const Scales *s, int k, ScalesBefore before, const CmdInput *in, Lhg *g);

#endif
