/* gridpoint.h - a gridded surface and other channels of a grid between its nodes, by bicubic.h. */
#ifndef GRIDPOINT_H
#define GRIDPOINT_H

#include "../base/chart.h"

enum {
	GRIDPOINT_EOUT = -1     /* vertex *at lies outside the rectangle */
};

/* n channels at (u,v).
 *
 * f        in   f[0] .. f[n-1], each [g.nv][g.nu], at least 2 x 2
 * u, v     in   clamped to [0,1] x [0,g.T]
 * x        out  [n] */
void gridpoint(Chart g, int n, const double *const f[], double u, double v, double *x);

/* The (u,v) of the vertices of a mesh, clamped to the rectangle of g.  v is scaled by g.T/T unless
 * T is 0 (not known).  (-1,-1), which means no (u,v), is kept.
 *
 * from     in   [nv][2], u in [0,1] and v in [0,T], to 1e-6 of it (mesh files that other
 *               programs wrote may hold floats)
 * to       out  [nv][2]
 *
 * Returns 0 or GRIDPOINT_EOUT. */
int gridpoint_uv(Chart g, double T, int nv, const double *from, double *to, int *at);

/* n channels of a grid at the (u,v) of the vertices of a mesh; a vertex without (u,v) keeps its
 * values.
 *
 * uv       in   [nv][2], of gridpoint_uv
 * x        in   [nv][n]
 *          out  the same */
void gridpoint_vertices(Chart g, int n, const double *const f[], int nv, const double *uv, double *x);

#endif
