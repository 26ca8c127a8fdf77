/* gridtree.h - the distance of points from a gridded surface, by a pyramid of boxes.
 *
 * The lowest level has one box for each block of 4 x 4 cells.  A box of the next higher level
 * contains a square of four of these, and so on up to a single box.  A search goes down into the
 * nearest box first, and leaves out boxes that are farther than the smallest distance found so far.
 */
#ifndef GRIDTREE_H
#define GRIDTREE_H

#include "../base/chart.h"
#include "../mesh/mesh.h"

enum { GRIDTREE_LEVELS = 16 };

typedef struct GridTree {
	const Mesh *m;          /* of mesh_from_grid, must outlive the tree */
	int     ncu, ncv;       /* cells in a row, and rows of cells (chart.h); the last may be short */
	int     cells;
	int     levels, nu[GRIDTREE_LEVELS], nv[GRIDTREE_LEVELS];       /* boxes along u and v */
	double *box[GRIDTREE_LEVELS];   /* [nv][nu][6] lowest x y z, highest x y z; box[0] is the
	                                 * single box, box[levels-1] the lowest level */
} GridTree;

/* g is the chart of m.  Returns 0 or MESH_ENOMEM, with nothing to free. */
int  gridtree_init(GridTree *t, const Mesh *m, Chart g);
void gridtree_free(GridTree *t);

/* The squared distance of x from the two triangles of cell number n. */
double gridtree_cell2(const GridTree *t, int n, const double x[3]);

/* The squared distance of x from the surface, if it is below bound2, else bound2. */
double gridtree_distance2(const GridTree *t, const double x[3], double bound2);

#endif
