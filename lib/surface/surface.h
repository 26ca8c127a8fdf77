/* surface.h - the surface of a conformal factor and a mean curvature (Theorem 1), by least squares
 * over positions, coarse to fine.
 *
 * Minimises the misfit (misfit.h) over all positions with the boundary curve held (8).  Grids go
 * from coarse to fine, and each starts from the one before.  The first is the coarsest grid, or
 * the finest that has no more nodes than the given start.  Several surfaces may share lambda, H
 * and the boundary: the start chooses among them and enters no equation.
 * doc/mathematics.md 6.1, 6.5, 6.6.
 *
 * With a free boundary, lambda and H determine the surface up to a rigid motion, except for the
 * surfaces (Bonnet's, e.g. of constant H) that can bend while keeping both; there the start
 * decides.
 */
#ifndef SURFACE_H
#define SURFACE_H

#include "fit.h"

enum {
	SURFACE_ENOMEM = -1,
	SURFACE_ESTART = -2,    /* no start is given and none is found (start.h) */
	SURFACE_EPLACE = -3     /* free: positions that are not finite or too large to be squared */
};

typedef struct Surface {
	Chart          g;
	const double  *lambda, *H;      /* [nv][nu], lambda > 0 */
	const Residue *residue;         /* or NULL */
	int            exact;           /* 1: the residues are of the same surface as lambda and H, so that E
	                                 * is 0 there */
	Chart          start_chart;     /* grid of the start, of the kind of g; its last column and row lie at */
	double         start_end[2];    /* start_end[0] of the width and start_end[1] of the height */
	const double  *start;           /* [3][nv][nu] of start_chart; NULL: one is made on the
	                                 * coarsest grid, from the outer rings of phi (start.h) */
	const MisfitPlace *place;       /* or NULL; the surface is held at it and starts from it, on the finest
	                                 * grid alone */
	int            filtered;        /* lambda and H are of no surface (misfit_set_firm) */
	int            free;            /* the boundary is not held */
	int            adrift;          /* free or closed: the border of phi is not given, but a start is */
	const double  *where;           /* adrift: [3][nv][nu], what places the result; NULL: the start */
	const double  *forecast;        /* [3][nv][nu], or NULL: a guess of the detail, added to the
	                                 * start of the finest grid */
	double        *detail;          /* out, or NULL: [3][nv][nu] the result minus the interpolated
	                                 * surface of the coarser grid, or minus the start */
} Surface;

/* phi     in/out  [3][nv][nu]: the border is given, the rest computed.  Where the boundary is
 *                 free, all is computed, then moved rigidly so that its border comes nearest
 *                 to the given one; adrift, so that its nodes come nearest to the start or to
 *                 `where`.  On a closed chart all is computed; adrift, it is moved so, by least
 *                 squares over the area; if not, it stays where its start (start.h) or its place was
 * o       in      tolerance and most hold for the finest grid; coarser ones stop at 1e-4 or
 *                 after 12 steps
 * at      out     progress at the last step
 *
 * Peak memory: 24 numbers for each node of the finest grid, besides lambda, H and phi, up to 27 for
 * unresolved nodes (patch.h), and 3 with exact residues.  Grids of fewer than 3 nodes in a direction
 * stay as they are.  Returns 1 if the fit on the finest grid converged or crept (at->stopped), 0 if not;
 * or SURFACE_ENOMEM, SURFACE_ESTART or SURFACE_EPLACE, phi being unspecified then. */
int surface(const Surface *s, const FitOptions *o, double *phi, FitProgress *at);

#endif
