/* warp.h - a map f of the chart of a surface A onto that of a surface B that brings corresponding
 * places together (doc/mathematics.md 8.7).
 *
 * Both charts are rectangles.  f maps [0,1] x [0,T], T the height of A's, onto itself, bijectively, with
 * fixed corners; v is then multiplied by T_B/T.  f = id + d, d a sum of sine and cosine modes
 * (warpmodes.h), minimises
 *
 *   1/2 mean |a - b o f|^2 + alpha D(f) + beta mean |f(p) - q|^2 :
 *
 * a, b the smoothed unit normals of A and of B, B moved rigidly onto A; D the distortion
 * (warpdistortion.h); p, q the landmarks.  It goes from few modes and much smoothing to many
 * modes and little; at each level the rigid motion is estimated again under the map of the last.
 */
#ifndef WARP_H
#define WARP_H

#include "../base/procrustes.h"

#include "warpimages.h"

enum {
	WARP_ENOMEM = -1,
	WARP_EVALUE = -2,       /* positions are not finite, or too large */
	WARP_EMU    = -3        /* |mu| stays above the limit, or f is folded between its nodes */
};

enum {
	WARP_MODES = 24,        /* in each direction */
	WARP_NODES = 129,       /* at most, in each direction, of the grid it is found on */
	WARP_LEVELS = 4
};

typedef struct Warp {
	double T;               /* height of A's chart */
	double c[2*WARP_MODES*WARP_MODES];      /* of warpmodes.h */
} Warp;

typedef struct WarpMarks {
	int n;
	const double (*p)[2], (*q)[2];  /* (u,v) on A's chart, and on B's with v times T/T_B */
} WarpMarks;

typedef struct WarpTask {
	const WarpSurface *a, *b;       /* on grids of equal size */
	double    T, stretch;           /* height of A's chart; T_B/T */
	int       normals;              /* 0: by landmarks only */
	WarpMarks marks;
	double    mumax;                /* the largest |mu| stays below */
} WarpTask;

typedef struct WarpFit {
	Rigid  move;            /* of B onto A */
	double alpha, stiff, mu_mean, mu_max;
	double apart;           /* mean over A's area of |n_A - n_B|^2, B moved by move: 0 .. 4 */
	double marks;           /* mean distance of f(p) and q; 0 without landmarks */
} WarpFit;

/* The size of the grid on which the map is found, for a grid of n nodes in one direction. */
static inline int
warp_nodes(int n)
{
	return n < WARP_NODES ? n : WARP_NODES;
}

/* The map f = id, and how it fits. */
int warp_identity(const WarpTask *t, Warp *w, WarpFit *fit);

/* Finds the map in the first `levels` levels, 1 .. WARP_LEVELS.  After all of them the last is
 * repeated, stiffer beyond the limit, until |mu| is below.  Returns 0, or a code above. */
int warp_find(const WarpTask *t, int levels, Warp *w, WarpFit *fit);

/* Sets f[2][nv][nu] to the image of the nodes of a grid on A's chart.  v is multiplied by stretch.
 * Nodes of sides lie on sides, exactly.  Returns 0, WARP_ENOMEM, or WARP_EMU if f is folded. */
int warp_field(const Warp *w, int nu, int nv, double stretch, double *f);

/* The image of the point (u,v) of A's chart, in [0,1] x [0,T]. */
void warp_at(const Warp *w, double u, double v, double f[2]);

#endif
