/* patch.h - direct solution of the equations of the nodes that the grid hardly resolves.
 *
 * The plate (plate.h) preconditions a node of weight o as if its stiffness were 1, but it is about
 * o^2.  So a few nodes of small o (nostrils, tips of ears) cause most of the CG steps.  Let S be
 * these nodes, A = J'J the matrix of a Gauss-Newton step (misfit.h), and A_SS its part on S,
 * factored.  Deflation starts CG where the residual vanishes on S, and corrects every direction so
 * that it stays 0 there: CG then only sees the Schur complement on the other nodes.
 * doc/mathematics.md 6.4. */
#ifndef PATCH_H
#define PATCH_H

#include "../sparse/spd.h"
#include "misfit.h"

enum {
	PATCH_ENOMEM = -1,
	PATCH_EINDEFINITE = -2  /* A_SS is singular to rounding, or not finite */
};

/* Vectors on S have three numbers a node: 3*number + coordinate. */
typedef struct Patch {
	const Misfit *m;
	int     nodes, rows, edge;      /* rows: nodes whose residuals depend on S; of these the first
	                                 * `edge` depend on other nodes too */
	int    *number;                 /* [nv*nu] number of a node of S, else -1 */
	int    *node;                   /* [nodes] */
	int    *row;                    /* [rows] */
	int    *beside;                 /* [rows][5] the node itself, and its neighbours */
	int    *place;                  /* [rows][5][5] for two of these nodes, the position of their block in
	                                 * its column of A_SS; -1 if it is not in the lower triangle of A_SS */
	double *J;                      /* [rows][6][15] derivatives of the weighted residuals */
	double *s;                      /* [edge][15] workspace of patch_correct */
	double *b;                      /* [3*nodes] */
	int    *column, *below;         /* lower triangle of A_SS, compressed columns */
	double *value;
	SpdFactor *factor;
} Patch;

/* Chooses S: the nodes with o < 0.3, the smallest first, at most 1 % of all (none if the boundary is
 * free); those beside cones where the first two lines have more than four times their weight, or 1.5 times
 * with a place (misfit_set_firm); and the neighbours of all these.  Without such nodes,
 * nodes is 0.  m must outlive p.  Returns 0 or PATCH_ENOMEM; p then holds nothing to free. */
int  patch_init(Patch *p, const Misfit *m);
void patch_free(Patch *p);

/* Computes and factors A_SS at phi.  Returns 0, PATCH_ENOMEM or PATCH_EINDEFINITE. */
int patch_set(Patch *p, const double *phi);

/* d_S = A_SS^-1 r_S.  Returns the decrease of E that d predicts, <r_S, d_S>, or NaN if there is no
 * memory. */
double patch_start(Patch *p, const double *r, double *d);

/* Changes z on S so that (A z)_S = 0.  Returns 0 or PATCH_ENOMEM. */
int patch_correct(Patch *p, double *z);

/* x_S = 0 */
void patch_clear(const Patch *p, double *x);

#endif
