/* mix.h - the channels of a blend. */
#ifndef CMD_MIX_H
#define CMD_MIX_H

#include "morph.h"

/* Prepares m for mix_channels: the excesses of its grids. */
void mix_begin(Morph *m);

/* Prints a note if a blend had far more excess than the grids. */
void mix_note(const Morph *m);

/* Adds the channels of the blend of the grids of m, frame k, to g, and sets T. */
void mix_channels(Morph *m, const double *w, int k, Lhg *g);

#endif
