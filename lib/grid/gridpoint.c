/* gridpoint.c - a gridded surface between its nodes. */
#include <math.h>
#include <string.h>

#include "bicubic.h"
#include "gridpoint.h"

static const double SLACK = 1e-6;       /* by which (u,v) may lie outside, of a side */

void
gridpoint(Chart g, const double *const phi[3], double u, double v, double x[3])
{
	const Bicubic b = bicubic_at(g.nu, g.nv, u*(g.nu - 1), v/g.T*(g.nv - 1));
	int c;

	for (c = 0; c < 3; c++)
		x[c] = bicubic_value(&b, phi[c]);
}

static int
within(double x, double side)
{
	return x >= -SLACK*side && x <= (1 + SLACK)*side;
}

int
gridpoint_move(Chart g, const double *const phi[3], const Soup *s, double *xyz, double *uv, int *at)
{
	const double T = s->T > 0 ? s->T : g.T;
	int p;

	for (p = 0; p < s->nv; p++) {
		const double *from = s->uv + 2*(size_t)p;
		double *to = uv + 2*(size_t)p, *x = xyz + 3*(size_t)p;

		memcpy(to, from, 2*sizeof *to);
		memcpy(x, s->xyz + 3*(size_t)p, 3*sizeof *x);
		if (from[0] == -1 && from[1] == -1)
			continue;
		if (!within(from[0], 1) || !within(from[1], T)) {
			*at = p;
			return GRIDPOINT_EOUT;
		}
		to[0] = fmin(fmax(from[0], 0), 1);
		to[1] = fmin(fmax(from[1], 0), T);
		if (T != g.T)
			to[1] = fmin(to[1]/T*g.T, g.T);
		gridpoint(g, phi, to[0], to[1], x);
	}
	return 0;
}
