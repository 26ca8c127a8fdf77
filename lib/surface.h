/* surface.h - the surface that fits a conformal factor and a mean curvature best.
 *
 * Minimises the misfit (misfit.h) over all positions with the boundary curve held, from
 * coarse grids to fine ones, each starting from the one before and the coarsest from a start
 * (or the first that has no more nodes than the start).  The start chooses among solutions -
 * a surface is not the only one with its lambda, H and boundary - and enters no equation.
 * DESIGN section 6.
 */
#ifndef SURFACE_H
#define SURFACE_H

#include "fit.h"

enum {
	SURFACE_ENOMEM = -1,
	SURFACE_ESTART = -2     /* no start is given and the frame method finds none */
};

typedef struct Surface {
	Chart          g;
	const double  *lambda, *H;      /* [nv][nu], lambda > 0 */
	const Residue *residue;         /* or NULL */
	Chart          start_chart;     /* of the start, whose last nodes are at start_end of the */
	double         start_end[2];    /* width and height, each <= 1 */
	const double  *start;           /* [3][nv][nu] of start_chart; NULL: the frame method on the
	                                 * coarsest grid, from the three outer rings of phi */
} Surface;

/* phi     in/out  [3][nv][nu]: the border is given, the rest computed
 * o       in      tolerance, most and report are meant for the finest grid; coarser ones
 *                 need no more than 1e-4 and 12 steps
 * at      out     of the last step
 *
 * Memory at its peak, in numbers a node of the finest grid: 24 beside lambda, H and phi.
 * Grids without an inner node stay as they are.  Returns 1 if the finest grid converged, 0 if
 * not, SURFACE_ENOMEM or SURFACE_ESTART; phi is then unspecified. */
int surface(const Surface *s, const FitOptions *o, double *phi, FitProgress *at);

#endif
