/* level.h - the grids from coarse to fine of the surface method: each has half as many steps as the next. */
#ifndef LEVEL_H
#define LEVEL_H

#include <stddef.h>

#include "../base/chart.h"

enum { LEVEL_ENOMEM = -1 };

typedef struct Level {
	Chart   g;
	double *lambda2, *l2H;  /* [nv][nu] lambda^2 and lambda^2 H */
	double *phi;            /* [3][nv][nu] positions */
} Level;

/* The number of nodes. */
size_t level_nodes(Chart g);

/* Whether a grid with fewer nodes than g would still have the least number. */
int level_has_coarser(Chart g);

/* The chart of the same kind with about `steps` steps along the axis with fewer, and in proportion along the
 * other; g itself if it has no more. */
Chart level_thinned(Chart g, int steps);

/* Makes the next coarser level l of f, with the boundary curve in its phi: half as many steps in both
 * directions, or only in the one with clearly shorter steps.  lambda^2 and lambda^2 H become hat-weighted
 * means.  Call level_free in any case.  Returns 0 or LEVEL_ENOMEM.  doc/mathematics.md 6.5. */
int level_coarsen(const Level *f, Level *l);

void level_free(Level *l);

/* Interpolates f [3] fields of grid `from`, times a factor, into phi of grid g; the outer `rings` rings of phi
 * stay.  The last column and row of `from` lie at end[0] of the width and end[1] of the height of g.
 * Returns 0 or LEVEL_ENOMEM. */
int level_interpolate(Chart from, const double end[2], const double *f, double factor, Chart g, int rings,
	double *phi);

#endif
