/* gridcell.h - the matrix of one cell of a gridded surface (gridlaplace.h).
 *
 * The matrix is that of E(f) = integral <grad f, A grad f> du dv over the cell, by a bilinear element with 2 x 2
 * quadrature points.
 */
#ifndef GRIDCELL_H
#define GRIDCELL_H

enum {
	GRIDLAPLACE_CELLS,      /* metric at Gauss points, central differences with weight 0.5 */
	GRIDLAPLACE_NODES       /* metric at the corners of the cells, central differences with
	                         * weight 0.9: nearly the metric of lambda and H (lambdah.h) */
};

/* A node of the surface, with its central differences. */
typedef struct GridNode {
	double phi[3], phi_u[3], phi_v[3];
} GridNode;

/* A cell with corners (i,j) (i+1,j) (i,j+1) (i+1,j+1) and steps h, k.  At a corner of sign -1, the
 * image of a node beyond a fold, phi_u and phi_v change their sign. */
typedef struct GridCell {
	const GridNode *corner[4];
	int             sign[4];
	double          h, k;
} GridCell;

/* How far the metric of the cell can be that of the surface, 0..1: 1 where the normals at its corners are within
 * about 12 degrees of their mean, falling to 0 at 37 degrees. */
double gridcell_trust(const GridCell *cell);

/* Sets m to the lower triangle of the 4 x 4 matrix, with trust A + (1 - trust) I in place of A;
 * metric is GRIDLAPLACE_CELLS or GRIDLAPLACE_NODES. */
void   gridcell_matrix(const GridCell *cell, int metric, double trust, double m[10]);

#endif
