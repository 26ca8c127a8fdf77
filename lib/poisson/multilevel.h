/* multilevel.h - one of the grids of multigrid.h.  Private to multigrid.
 *
 * Fields are stored with a rim of one node around the unknowns, [n[1]+2][n[0]+2].  The rim holds the
 * neighbours beyond the sides, so that the operators need not ask where a node lies. */
#ifndef MULTILEVEL_H
#define MULTILEVEL_H

#include <stddef.h>

#include "../base/chart.h"

enum { MULTILEVEL_ENOMEM = -1, MULTILEVEL_MANY = 100000 };

/* The weights with which a coarse node receives the unknowns from .. from+n-1 along one axis; the other
 * weights are 0.  A grid has at most twice the steps of the next coarser one, so n is at most 4. */
enum { TAPS = 4 };
typedef struct Taps {
	int    from, n;
	double w[TAPS];
} Taps;

typedef struct Multilevel {
	Chart   g;
	int     held;
	int     from[2], n[2];          /* the unknowns: n nodes from node `from` on, along u and v */
	int     rims, *rim, *source;    /* x[rim] = x[source], or 0 if source < 0 */
	double *width[2];               /* of the cells of the nodes along u and v, in steps: 1, or 1/2 on free
	                                 * sides */
	double *mass, *inverse;         /* the diagonal of M; 1/(the diagonal of A) */
	double *x, *b, *r;              /* solution, right-hand side, residual */
	/* Interpolation from the next coarser grid.  An unknown i lies between the coarse nodes at[i]
	 * and at[i] + 1, counted with the rim, share[i] of the way.  taps[I] is the transpose. */
	int    *at[2];
	double *share[2];
	Taps   *taps[2];
} Multilevel;

/* A grid for the unknowns of g.  Returns 0 or MULTILEVEL_ENOMEM; l then holds nothing to free. */
int  multilevel_init(Multilevel *l, Chart g, int held);
void multilevel_free(Multilevel *l);

/* The chart of the next coarser grid: half the steps along both axes, or along the one whose steps are
 * clearly shorter.  Returns 0 if there is none. */
int  multilevel_coarser(const Multilevel *l, Chart *g);

/* Prepares the interpolation from grid c to grid l.  Returns 0 or MULTILEVEL_ENOMEM. */
int  multilevel_join(Multilevel *l, const Multilevel *c);

/* Sets the rim of a field x. */
void multilevel_fill_rim(const Multilevel *l, double *x);

/* l->inverse, for this t. */
void multilevel_diagonal(Multilevel *l, double t);

/* y = t K x + c M x without the rim; sets the rim of x. */
void multilevel_apply(const Multilevel *l, double t, double c, double *x, double *y);

/* l->r = l->b - A l->x. */
void multilevel_residual(Multilevel *l, double t);

/* A step of Jacobi, x += w D^-1 (b - A x), with l->r as workspace; the first, from x = 0. */
void multilevel_relax(Multilevel *l, double t, double w);
void multilevel_begin(Multilevel *l, double w);

/* to = P' f for a field f of l; x of l += P x of c, with l->r as workspace.  P is bilinear
 * interpolation. */
void multilevel_restrict(const Multilevel *l, const Multilevel *c, const double *f, double *to);
void multilevel_prolong(Multilevel *l, Multilevel *c);

/* The length of a stored row, and the place of unknown (i,j) in the stored fields. */
static inline size_t
multilevel_row(const Multilevel *l)
{
	return (size_t)l->n[0] + 2;
}

static inline size_t
multilevel_place(const Multilevel *l, int i, int j)
{
	return (j + 1)*multilevel_row(l) + i + 1;
}

/* Whether there are so many unknowns that rows are divided among threads. */
static inline int
multilevel_many(const Multilevel *l)
{
	return l->n[0] > MULTILEVEL_MANY/l->n[1];
}

#endif
