/* chart.c - the kinds of charts. */
#include <math.h>
#include <stddef.h>
#include <string.h>

#include "chart.h"
#include "pillowplane.h"
#include "sockplane.h"

static int
wrap(int i, int n)
{
	while (i < 0)
		i += n;
	while (i >= n)
		i -= n;
	return i;
}

static int
sock_beyond(Chart g, int *i, int *j)
{
	int out = *j < 0;

	if (out) {
		*j = -1 - *j;
		*i = g.nu - 1 - *i;
	}
	*i = wrap(*i, g.nu);
	return out ? -1 : 1;
}

static int
pillow_beyond(Chart g, int *i, int *j)
{
	int out = *j < 0 || *j >= g.nv;

	if (out) {
		*j = *j < 0 ? -1 - *j : 2*g.nv - 1 - *j;
		*i = g.nu - 1 - *i;
	}
	*i = wrap(*i, g.nu);
	return out ? -1 : 1;
}

/* Cell n of the rows, of which each has `across`. */
static void
row_cell(Chart g, int n, int across, int corner[4])
{
	int i = n%across, j = n/across, east = (i + 1)%g.nu;

	corner[0] = j*g.nu + i;
	corner[1] = j*g.nu + east;
	corner[2] = (j + 1)*g.nu + east;
	corner[3] = (j + 1)*g.nu + i;
}

static int
rectangle_cells(Chart g)
{
	return (g.nu - 1)*(g.nv - 1);
}

static void
rectangle_cell(Chart g, int n, int corner[4])
{
	row_cell(g, n, g.nu - 1, corner);
}

/* The row j = -1 of cells is the fold: column i of it is column nu-2-i, and of columns nu/2-1 and nu-1
 * only an edge remains. */
static int
sock_cells(Chart g)
{
	return g.nu*(g.nv - 1) + g.nu/2 - 1;
}

static void
sock_cell(Chart g, int n, int corner[4])
{
	int i = n - g.nu*(g.nv - 1);

	if (i < 0) {
		row_cell(g, n, g.nu, corner);
		return;
	}
	corner[0] = g.nu - 1 - i;
	corner[1] = g.nu - 2 - i;
	corner[2] = i + 1;
	corner[3] = i;
}

/* The cells of the fold at v = 0 precede those of the fold at v = T. */
static int
pillow_cells(Chart g)
{
	return sock_cells(g) + g.nu/2 - 1;
}

static void
pillow_cell(Chart g, int n, int corner[4])
{
	int i = n - sock_cells(g), top = (g.nv - 1)*g.nu;

	if (i < 0) {
		sock_cell(g, n, corner);
		return;
	}
	corner[0] = top + i;
	corner[1] = top + i + 1;
	corner[2] = top + g.nu - 2 - i;
	corner[3] = top + g.nu - 1 - i;
}

/* A row of the round surface of the sock or the pillow, at the height v of `plane`.  It is the same at u, u + 1/2
 * and 1/2 - u: half a turn about its axis, and a reflection. */
static void
round_row(Chart g, const SockPlane *plane, double v, double *lambda0)
{
	int i, half = g.nu/2;

	for (i = 0; 2*i < half; i++)
		lambda0[i] = lambda0[half-1-i] = sockplane_round(plane, chart_u(g, i), v);
	for (i = half; i < g.nu; i++)
		lambda0[i] = lambda0[i-half];
}

/* A hemisphere. */
static void
sock_round(Chart g, double *lambda0)
{
	SockPlane plane = sockplane(g.T);
	int j;

	for (j = 0; j < g.nv; j++)
		round_row(g, &plane, chart_v(g, j), lambda0 + (size_t)j*g.nu);
}

/* A sphere.  Its halves v < T/2 and v > T/2 are mirror images. */
static void
pillow_round(Chart g, double *lambda0)
{
	PillowPlane plane = pillowplane(g.T);
	int j;

	for (j = 0; 2*j < g.nv; j++)
		round_row(g, &plane.half, fmin(chart_v(g, j), g.T/2), lambda0 + (size_t)j*g.nu);
	for (; j < g.nv; j++)
		memcpy(lambda0 + (size_t)j*g.nu, lambda0 + (size_t)(g.nv - 1 - j)*g.nu, g.nu*sizeof *lambda0);
}

const ChartKind CHART_RECTANGLE = { "rectangle", .cells = rectangle_cells, .cell = rectangle_cell,
    .lowest = 1e-9, .highest = 1e9 };
const ChartKind CHART_SOCK = { "sock", .joined = { { 1, 1 }, { 1, 0 } }, .beyond = sock_beyond,
    .cells = sock_cells, .cell = sock_cell, .round = sock_round, .lowest = 1e-3, .highest = 50, .folded = 1, .cones = 2,
    .cone = { { 0, 0 }, { 0.5, 0 } } };
const ChartKind CHART_PILLOW = { "pillow", .joined = { { 1, 1 }, { 1, 1 } }, .beyond = pillow_beyond,
    .cells = pillow_cells, .cell = pillow_cell, .round = pillow_round, .lowest = 2e-3, .highest = 100, .folded = 2,
    .closed = 1, .cones = 4, .cone = { { 0, 0 }, { 0.5, 0 }, { 0, 1 }, { 0.5, 1 } } };

const ChartKind *
chart_kind(const char *name)
{
	static const ChartKind *const kind[] = { &CHART_RECTANGLE, &CHART_SOCK, &CHART_PILLOW };
	size_t i;

	for (i = 0; i < sizeof kind/sizeof *kind; i++)
		if (strcmp(name, kind[i]->name) == 0)
			return kind[i];
	return NULL;
}

void
chart_round(Chart g, double *lambda0)
{
	int p;

	if (g.kind->round)
		g.kind->round(g, lambda0);
	else
		for (p = 0; p < g.nu*g.nv; p++)
			lambda0[p] = 1;
}

double
chart_from_cone(Chart g, int c, int p)
{
	double du = fabs(chart_u(g, p%g.nu) - g.kind->cone[c][0]);

	if (g.kind->joined[0][0])
		du = fmin(du, fabs(1 - du));
	return hypot(du, chart_v(g, p/g.nu) - g.T*g.kind->cone[c][1]);
}
