/* cornerfold.h - cells that are turned over near the corners of a grid. */
#ifndef CORNERFOLD_H
#define CORNERFOLD_H

#include "../base/chart.h"

/* Whether corner k, counterclockwise from (0,0), lies between two open sides. */
int corner_exists(Chart g, int k);

/* The node a steps along u and b along v from corner k into the grid. */
int corner_node(Chart g, int k, int a, int b);

/* n = the normal of cell (a,b), counted from corner k, of any length. */
void corner_cell_normal(Chart g, int k, const double *const phi[3], int a, int b, double n[3]);

/* Whether the normal of cell (a,b), counted from corner k, makes more than a right angle with that of a
 * cell beside it, or is undefined.  (a,b) and the cells beside it must be in the grid. */
int corner_cell_folded(Chart g, int k, const double *const phi[3], int a, int b);

/* The number of folded cells within `radius` cells of corner k. */
int corner_folds(Chart g, int k, const double *const phi[3], int radius);

#endif
