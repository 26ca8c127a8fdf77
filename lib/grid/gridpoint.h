/* gridpoint.h - values of channels of a grid between its nodes, by bicubic.h. */
#ifndef GRIDPOINT_H
#define GRIDPOINT_H

#include "../base/chart.h"

enum {
	GRIDPOINT_EOUT = -1     /* vertex *at lies outside the chart */
};

/* The values of n channels at (u,v).
 *
 * f        in   f[0] .. f[n-1], each [g.nv][g.nu], at least 2 x 2; at least 6 along an axis with a
 *               joined side
 * u, v     in   clamped to [0,1] x [0,g.T]
 * x        out  [n] */
void gridpoint(Chart g, int n, const double *const f[], double u, double v, double *x);

/* The (u,v) of the vertices of a mesh, clamped to [0,1] x [0,g.T].  v is multiplied by
 * g.T/T, unless T is 0 (not known).  (-1,-1) means that a vertex has no (u,v), and is kept.
 *
 * from     in   [nv][2], u in [0,1] and v in [0,T]; errors up to 1e-6 of a side are allowed,
 *               because mesh files of other programs may hold floats
 * to       out  [nv][2]
 *
 * Returns 0 or GRIDPOINT_EOUT. */
int gridpoint_uv(Chart g, double T, int nv, const double *from, double *to, int *at);

/* The values of n channels of a grid at the (u,v) of the vertices of a mesh.  A vertex without
 * (u,v) keeps its values.
 *
 * uv       in      [nv][2], of gridpoint_uv
 * x        in/out  [nv][n] */
void gridpoint_vertices(Chart g, int n, const double *const f[], int nv, const double *uv, double *x);

#endif
