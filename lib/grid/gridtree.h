/* gridtree.h - the distance of points from a gridded surface, by a pyramid of boxes.
 *
 * The boxes of blocks of 4 x 4 cells are joined two by two along u and v up to one box.  A
 * search goes down into the nearer boxes first and leaves out those farther than the best so far.
 */
#ifndef GRIDTREE_H
#define GRIDTREE_H

#include "../mesh/mesh.h"

enum { GRIDTREE_LEVELS = 16 };

typedef struct GridTree {
	const Mesh *m;          /* of mesh_from_grid, must outlive the tree */
	int     ncu, ncv;       /* cells along u and v */
	int     levels, nu[GRIDTREE_LEVELS], nv[GRIDTREE_LEVELS];
	double *box[GRIDTREE_LEVELS];   /* [nv][nu][6] lowest and highest x y z; box[0] holds all */
} GridTree;

/* nu x nv: the nodes of m.  Returns 0 or MESH_ENOMEM, with nothing to free. */
int  gridtree_init(GridTree *t, const Mesh *m, int nu, int nv);
void gridtree_free(GridTree *t);

/* The squared distance of x from the two triangles of cell (i,j). */
double gridtree_cell2(const GridTree *t, int i, int j, const double x[3]);

/* The squared distance of x from the surface, if it is below bound2, else bound2. */
double gridtree_distance2(const GridTree *t, const double x[3], double bound2);

#endif
