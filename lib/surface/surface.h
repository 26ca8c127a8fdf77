/* surface.h - the surface that fits a conformal factor and a mean curvature best.
 *
 * Minimises the misfit (misfit.h) over all positions with the boundary curve held, from
 * coarse grids to fine ones, each starting from the one before and the coarsest from a start
 * (or the first that has no more nodes than the start).  The start chooses among solutions -
 * a surface is not the only one with its lambda, H and boundary - and enters no equation.
 * doc/mathematics.md 6.5.
 *
 * With a free boundary lambda and H alone determine the surface up to a motion (Bonnet), but
 * for the surfaces that bend with H kept, as those of constant H do: then the start decides.
 */
#ifndef SURFACE_H
#define SURFACE_H

#include "fit.h"

enum {
	SURFACE_ENOMEM = -1,
	SURFACE_ESTART = -2,    /* no start is given and the frame method finds none */
	SURFACE_EPLACE = -3     /* free: positions that are not finite or too large to be squared */
};

typedef struct Surface {
	Chart          g;
	const double  *lambda, *H;      /* [nv][nu], lambda > 0 */
	const Residue *residue;         /* or NULL */
	Chart          start_chart;     /* of the start, whose last nodes are at start_end of the */
	double         start_end[2];    /* width and height, each <= 1 */
	const double  *start;           /* [3][nv][nu] of start_chart; NULL: the frame method on the
	                                 * coarsest grid, from the three outer rings of phi */
	int            free;            /* the boundary is not held */
	int            adrift;          /* free: the border of phi is not given, a start is */
	const double  *forecast;        /* [3][nv][nu] of the detail, or NULL: where the finest grid begins */
	double        *detail;          /* out, or NULL: [3][nv][nu] what the finest grid's steps have
	                                 * added to what came from the coarser one or the start */
} Surface;

/* phi     in/out  [3][nv][nu]: the border is given, the rest computed.  Where the boundary is
 *                 free, all is, and is moved so that its border comes nearest to the given
 *                 one; adrift, so that its nodes come nearest to those of the start
 * o       in      tolerance, most and report are meant for the finest grid; coarser ones
 *                 need no more than 1e-4 and 12 steps
 * at      out     of the last step
 *
 * Memory at its peak, in numbers a node of the finest grid: 24 beside lambda, H and phi.
 * Grids without an inner node stay as they are.  Returns 1 if the finest grid converged, 0 if
 * not, SURFACE_ENOMEM, SURFACE_ESTART or SURFACE_EPLACE; phi is then unspecified. */
int surface(const Surface *s, const FitOptions *o, double *phi, FitProgress *at);

#endif
