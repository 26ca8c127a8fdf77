/* ownmetric.h - the filters of lhfft that act in the metric of the surface: --scale and --relief. */
#ifndef CMD_OWNMETRIC_H
#define CMD_OWNMETRIC_H

#include "scales.h"

/* Filters lambda, H and the place of g, if it has one, at scale k of s, or dies.  Sets the metadata scale,
 * waves and, for --relief, relief.  before: the metadata of the input. */
void ownmetric_apply(const Scales *s, int k, ScalesBefore before, const CmdInput *in, Lhg *g);

#endif
