/* carry.c - displacements of points by interpolation. */
#include <math.h>
#include <stdlib.h>

#include "../grid/bicubic.h"
#include "../grid/stencil.h"
#include "carry.h"

enum { PASSES = 100 };

/* The place to which node p is moved, in grid steps. */
static void
image(Chart g, const Shift *s, int p, double x[2])
{
	x[0] = p%g.nu + s->du[p];
	x[1] = p/g.nu + s->dv[p];
}

/* Whether the cell whose first node is p has a corner at which it is turned over or flat. */
static int
is_turned(Chart g, const Shift *s, int p)
{
	const int node[4] = { p, p + 1, p + 1 + g.nu, p + g.nu };
	double x[4][2];
	int k, turned = 0;

	for (k = 0; k < 4; k++)
		image(g, s, node[k], x[k]);
	for (k = 0; k < 4; k++) {
		const double *o = x[k], *a = x[(k+1)%4], *b = x[(k+3)%4];

		turned |= !((a[0] - o[0])*(b[1] - o[1]) > (b[0] - o[0])*(a[1] - o[1]));
	}
	return turned;
}

/* Replaces the displacement of node p by the mean of its neighbours'; a node of a side stays on
 * it. */
static void
smooth(Chart g, const Shift *s, int p)
{
	int i = p%g.nu, j = p/g.nu, inner_u = i > 0 && i < g.nu - 1, inner_v = j > 0 && j < g.nv - 1;
	double du = 0, dv = 0;

	if (inner_u)
		du += s->du[p-1] + s->du[p+1], dv += s->dv[p-1] + s->dv[p+1];
	if (inner_v)
		du += s->du[p-g.nu] + s->du[p+g.nu], dv += s->dv[p-g.nu] + s->dv[p+g.nu];
	if (inner_u)
		s->du[p] = du/(2*inner_u + 2*inner_v);
	if (inner_v)
		s->dv[p] = dv/(2*inner_u + 2*inner_v);
}

/* Smooths at turned cells until none is turned. */
static void
turn_back(Chart g, const Shift *s)
{
	int pass, p, turned = 1;

	for (pass = 0; pass < PASSES && turned; pass++)
		for (turned = 0, p = 0; p < g.nu*(g.nv - 1); p++)
			if (p%g.nu < g.nu - 1 && is_turned(g, s, p)) {
				smooth(g, s, p);
				smooth(g, s, p + 1);
				smooth(g, s, p + g.nu);
				smooth(g, s, p + g.nu + 1);
				turned = 1;
			}
}

/* The first node of the cell at x, along an axis. */
static int
cell_of(Chart g, int axis, double x)
{
	int last = (axis ? g.nv : g.nu) - 2;

	return !g.kind->joined[axis][1] && x >= last ? last : (int)floor(x);
}

/* The odd field f at (i,j). */
static double
odd(Chart g, const double *f, int i, int j)
{
	int sign = 1;
	size_t p = stencil_node(g, i, j, &sign);

	return sign*f[p];
}

/* Bilinear interpolation of the odd field f at (x,y), in grid steps. */
static double
bilinear(Chart g, const double *f, double x, double y)
{
	int i = cell_of(g, 0, x), j = cell_of(g, 1, y);
	double t = x - i, r = y - j;

	return (1 - r)*((1 - t)*odd(g, f, i, j) + t*odd(g, f, i + 1, j)) +
	    r*((1 - t)*odd(g, f, i, j + 1) + t*odd(g, f, i + 1, j + 1));
}

/* A coordinate of a moved point, between the open sides at 0 and n, from its values by bicubic and by bilinear
 * interpolation.  The bilinear value keeps inner points inside.  Where the displacement varies much
 * within a cell, the bicubic value may lie outside, and all points of a limb would end at one place on
 * a side.  So each distance from a side is kept within a factor of two of the bilinear one. */
static double
keep_off(const int joined[2], double cubic, double linear, int n)
{
	double x = joined[0] ? cubic : fmin(fmax(cubic, linear/2), 2*linear);

	return joined[1] ? x : fmax(fmin(x, n - (n - linear)/2), n - 2*(n - linear));
}

/* Replaces (u,v) by its image within the chart. */
static void
bring_back(const ChartKind *kind, double *u, double *v)
{
	if (kind->folded && *v < 0)
		*u = 1 - *u, *v = -*v;
	if (kind->joined[0][0])
		*u -= floor(*u);
}

/* x in grid steps from the first node, kept between open sides. */
static double
in_steps(Chart g, int axis, double share)
{
	const int *joined = g.kind->joined[axis];
	double steps = chart_steps(g, axis), x = share*steps - 0.5*joined[0];

	x = joined[0] ? x : fmax(x, 0);
	return joined[1] ? x : fmin(x, (axis ? g.nv : g.nu) - 1);
}

/* The share of the width or height at x in steps, not beyond open sides. */
static double
share_of(Chart g, int axis, double x)
{
	const int *joined = g.kind->joined[axis];

	x = (x + 0.5*joined[0])/chart_steps(g, axis);
	x = joined[0] ? x : fmax(x, 0);
	return joined[1] ? x : fmin(x, 1);
}

void
carry_points(Chart g, Shift *s, int n, double *pu, double *pv)
{
	const int (*joined)[2] = g.kind->joined;
	int i;

	if (n > 0)
		turn_back(g, s);
	#pragma omp parallel for schedule(static)
	for (i = 0; i < n; i++) {
		double x = in_steps(g, 0, pu[i]), y = in_steps(g, 1, pv[i]/g.T);
		Bicubic at = bicubic_at(g, x, y);
		double a = keep_off(joined[0], x + bicubic_odd(&at, s->du), x + bilinear(g, s->du, x, y), g.nu - 1);
		double b = keep_off(joined[1], y + bicubic_odd(&at, s->dv), y + bilinear(g, s->dv, x, y), g.nv - 1);

		pu[i] = share_of(g, 0, a);
		pv[i] = share_of(g, 1, b)*s->T;
		bring_back(g.kind, &pu[i], &pv[i]);
	}
}
