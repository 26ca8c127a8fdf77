/* gridpoint.c - channels of a grid at given (u,v). */
#include <math.h>
#include <string.h>

#include "bicubic.h"
#include "gridpoint.h"

static const double SLACK = 1e-6;       /* (u,v) may lie outside by this fraction of a side */

void
gridpoint(Chart g, int n, const double *const f[], double u, double v, double *x)
{
	const Bicubic b = bicubic_at(g, u*chart_steps(g, 0) - 0.5*g.kind->joined[0][0],
	    v/g.T*chart_steps(g, 1) - 0.5*g.kind->joined[1][0]);
	int c;

	for (c = 0; c < n; c++)
		x[c] = bicubic_value(&b, f[c]);
}

static int
within(double x, double side)
{
	return x >= -SLACK*side && x <= (1 + SLACK)*side;
}

static int
has_uv(const double *uv)
{
	return uv[0] != -1 || uv[1] != -1;
}

int
gridpoint_uv(Chart g, double T, int nv, const double *from, double *to, int *at)
{
	int p;

	T = T > 0 ? T : g.T;
	for (p = 0; p < nv; p++, from += 2, to += 2) {
		memcpy(to, from, 2*sizeof *to);
		if (!has_uv(from))
			continue;
		if (!within(from[0], 1) || !within(from[1], T)) {
			*at = p;
			return GRIDPOINT_EOUT;
		}
		to[0] = fmin(fmax(from[0], 0), 1);
		to[1] = fmin(fmax(from[1], 0), T);
		if (T != g.T)
			to[1] = fmin(to[1]/T*g.T, g.T);
	}
	return 0;
}

void
gridpoint_vertices(Chart g, int n, const double *const f[], int nv, const double *uv, double *x)
{
	int p;

	for (p = 0; p < nv; p++, uv += 2, x += n)
		if (has_uv(uv))
			gridpoint(g, n, f, uv[0], uv[1], x);
}
