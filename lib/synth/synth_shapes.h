/* synth_shapes.h - the kinds of synth.h: one list for each file with formulas. */
#ifndef SYNTH_SHAPES_H
#define SYNTH_SHAPES_H

#include "synth.h"

/* Each list ends with a row without a name. */
extern const SynthKind synth_shapes[];  /* plane pieces and patches of classical surfaces */
extern const SynthKind synth_strips[];  /* spiral, moebius */
extern const SynthKind synth_reliefs[]; /* face, tooth, cortex */

#endif
