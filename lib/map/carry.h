/* carry.h - points that move with a grid when it is mapped onto itself. */
#ifndef CARRY_H
#define CARRY_H

#include "../base/chart.h"

/* The map of a grid onto itself as displacements in grid steps: node (i,j) goes to
 * (i + du, j + dv). */
typedef struct Shift {
	double *du, *dv, T;     /* [nv][nu]; T: height of the new chart */
} Shift;

/* Moves n points (pu,pv) of the chart g by the shift, to the new chart of height s->T.  Points inside
 * stay inside; points of a side stay on it.  Cells much too large for the surface may be turned over;
 * then the displacements of their nodes are smoothed first, and s changes there. */
void carry_points(Chart g, Shift *s, int n, double *pu, double *pv);

#endif
