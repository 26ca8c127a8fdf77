/* morph.h - the two grids of lhinterp and the interpolation between them. */
#ifndef CMD_MORPH_H
#define CMD_MORPH_H

#include "../../lib/morph/matching.h"
#include "../shared/cmd.h"

typedef struct Morph {
	CmdInput A, B;
	Lhg      a, b;
	int      has_border, landmarks; /* 1: border and match are set; 1: match comes from landmarks */
	Border   border[2];
	Matching match;
} Morph;

/* Read both grids, or die if they do not fit each other.  landmarks: a file, or NULL; scaled,
 * aligned: whether --scale and --align are given. */
void morph_open(Morph *m, const char *pathA, const char *pathB, const char *landmarks, int scaled,
	int aligned);

/* The grid at t, 0 .. 1, frame k of n. */
void morph_at(const Morph *m, double t, int k, int n, Lhg *g);

void morph_free(Morph *m);

#endif
