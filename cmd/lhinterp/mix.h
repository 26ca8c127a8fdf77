/* mix.h - the channels of a blend. */
#ifndef CMD_MIX_H
#define CMD_MIX_H

#include "morph.h"

/* Prepares m for mix_channels: the excesses of its grids. */
void mix_begin(Morph *m);

/* Prints a note if a blend had far more excess than the grids. */
void mix_note(const Morph *m);

/* The height T of the blend, > 0: with weights below 0 there need not be one. */
double mix_height(const Morph *m, const double *w);

/* Adds the channels of the blend of the grids of m, frame k, to g.  border is that of the blend, measured,
 * or NULL if lambda does not follow it. */
void mix_channels(Morph *m, const double *w, int k, const Border *border, Lhg *g);

#endif
