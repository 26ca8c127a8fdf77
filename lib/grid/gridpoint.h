/* gridpoint.h - a gridded surface between its nodes., by bicubic.h. */
#ifndef GRIDPOINT_H
#define GRIDPOINT_H

#include "../base/chart.h"
#include "../mesh/mesh.h"

enum {
	GRIDPOINT_EOUT = -1     /* vertex *at lies outside the rectangle */
};

/* phi(u,v).
 *
 * phi      in   phi[0], phi[1], phi[2]: x, y, z, each [g.nv][g.nu], at least 2 x 2
 * u, v     in   clamped to [0,1] x [0,g.T]
 * x        out */
void gridpoint(Chart g, const double *const phi[3], double u, double v, double x[3]);

/* The vertices of s at their (u,v), where s->uv has any: those of (-1,-1) stay where they
 * are.  When s->T is known and differs from g.T, v is scaled by g.T/s->T.
 *
 * s        in   uv must be there; u in [0,1] and v in [0,T], to 1e-6 of it (mesh files
 *               that other programs wrote may hold floats)
 * xyz, uv  out  [s->nv][3] and [s->nv][2]: positions, and (u,v) in the rectangle of g
 *
 * Returns 0 or GRIDPOINT_EOUT. */
int gridpoint_move(Chart g, const double *const phi[3], const Soup *s, double *xyz, double *uv,
	int *at);

#endif
