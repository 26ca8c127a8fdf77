/* morph.h - the grids of lhinterp and their blends. */
#ifndef CMD_MORPH_H
#define CMD_MORPH_H

#include "../../lib/morph/matching.h"
#include "../shared/cmd.h"

enum { MORPH_MOST = CMD_MOST_MARKS };     /* grids */

/* The rules for lambda, H and the residual channels, in the order of the words of --rule. */
enum { MORPH_METRIC, MORPH_LINEAR };

/* One of the grids, brought into line with the first. */
typedef struct Source {
	CmdInput in;
	Lhg      g;
	Border   border;        /* if Morph.has_border */
	Matching match;         /* likewise: with the border of the first grid; not of the first itself */
	double  *excess;        /* [nv][nu] (cap.h), or NULL */
} Source;

typedef struct MorphOptions {
	const char *landmarks;  /* a file, or NULL; for two grids */
	int scale, align, cap;  /* whether --scale, --align, --cap are given */
	int free;               /* 1: lambda does not follow the length of the border */
	int rule;
} MorphOptions;

typedef struct Morph {
	const MorphOptions *o;
	int     n;
	Source *s;              /* [n] */
	int     has_border;
	int     residual;       /* 1: the grids have residual channels */
	double *work;           /* [nv][nu] for excesses, two of them, or NULL */
	double  most;           /* the largest integral of excess beyond the grids' own, of the blends so far, */
	int     worst;          /* and its frame */
} Morph;

/* Read n >= 2 grids, or die if they do not fit each other. */
void morph_open(Morph *m, int n, char *const path[], const MorphOptions *o);

/* The blend with these weights, whose sum is 1, as frame k of frames.  It has the metadata that all grids
 * have in common; the caller adds those of the parameter. */
void morph_blend(Morph *m, const double *w, int k, int frames, Lhg *g);

/* Prints the note about the excess, if there is one, and frees m. */
void morph_close(Morph *m);

#endif
