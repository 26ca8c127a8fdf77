/* synth_shapes.h - the kinds of synth.h: one list for each file with formulas. */
#ifndef SYNTH_SHAPES_H
#define SYNTH_SHAPES_H

#include "synth.h"

/* Each list ends with a row without a name. */
extern const SynthKind synth_shapes[];  /* plane pieces and patches of classical surfaces */
extern const SynthKind synth_strips[];  /* spiral, moebius */
extern const SynthKind synth_reliefs[]; /* face, tooth, cortex */
extern const SynthKind synth_closed[];  /* closed surfaces */

/* synth_mesh of a closed surface. */
int synth_sphere_mesh(const Synth *s, int n, uint64_t seed, Mesh *m, double **xy);

#endif
