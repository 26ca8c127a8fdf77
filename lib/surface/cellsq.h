/* cellsq.h - linear least squares over the cells of a grid.
 *
 * Unknowns are `fields` numbers at every node.  Each cell gives `rows` equations in the
 * 4*fields unknowns at its corners.  Several right-hand sides share the matrix.  Values on the
 * outer `held` rings of nodes are data.  Equations use averages and differences of the four
 * corners: central differences at nodes leave odd-even modes free (doc/mathematics.md 7.2).
 *
 * minimised   sum over cells |A_cell x_corners - b_cell|^2
 * over        x at the nodes at least `held` steps from the edge
 * held fixed  x elsewhere
 * by          the normal equations, CHOLMOD, nested dissection of the rectangle
 */
#ifndef CELLSQ_H
#define CELLSQ_H

#include "../base/chart.h"
#include "../sparse/spd.h"

enum { CELLSQ_MAXFIELDS = 3, CELLSQ_MAXROWS = 6, CELLSQ_MAXRHS = 3 };

/* A cell's corners are numbered 0: (i,j), 1: (i+1,j), 2: (i,j+1), 3: (i+1,j+1); its
 * unknowns: corner*fields + field. */
typedef struct CellRows {
	double A[CELLSQ_MAXROWS][4*CELLSQ_MAXFIELDS];
	double b[CELLSQ_MAXROWS][CELLSQ_MAXRHS];
} CellRows;

typedef struct CellSystem {
	Chart g;
	int   fields, rows, rhs, held;
	/* Fills the equations of cell (i,j); everything is 0 on entry. */
	void (*cell)(const void *ctx, int i, int j, CellRows *r);
	const void *ctx;
} CellSystem;

/* y = A x.  x is [node][field][rhs], y is [cell][row][rhs], cells in row order. */
void cellsq_apply(const CellSystem *s, const double *x, double *y);

/* x = A' y, the adjoint. */
void cellsq_adjoint(const CellSystem *s, const double *y, double *x);

/* x in: values on the held rings; out: all values.  Returns 0, SPD_ENOMEM, SPD_EINDEFINITE or
 * SPD_ELARGE; x is then unspecified.  report may be NULL. */
int cellsq_solve(const CellSystem *s, double *x, SpdReport *report);

#endif
