/* fold.c - cells of a grid that are turned over against a neighbour. */
#include <string.h>

#include "../base/vec3.h"
#include "fold.h"
#include "stencil.h"

/* Whether (i,j) is a cell: its four nodes are in the grid, or across the seam of u. */
static int
is_cell(Chart g, int i, int j)
{
	return j >= 0 && j < g.nv - 1 && (g.kind->joined[0][0] || (i >= 0 && i < g.nu - 1));
}

/* The nodes of cell (i,j), anticlockwise. */
static void
nodes(Chart g, int i, int j, size_t p[4])
{
	int sign = 1, k;

	for (k = 0; k < 4; k++)
		p[k] = stencil_node(g, i + (k == 1 || k == 2), j + k/2, &sign);
}

/* n = (a - b) x (c - d), for four nodes. */
static void
cross_nodes(const double *const phi[3], size_t a, size_t b, size_t c, size_t d, double n[3])
{
	double x[3], y[3];
	int k;

	for (k = 0; k < 3; k++) {
		x[k] = phi[k][a] - phi[k][b];
		y[k] = phi[k][c] - phi[k][d];
	}
	cross3(x, y, n);
}

static void
normal(Chart g, const double *const phi[3], int i, int j, double n[3])
{
	size_t p[4];

	nodes(g, i, j, p);
	cross_nodes(phi, p[2], p[0], p[3], p[1], n);
}

/* Whether a corner of cell (i,j) is turned over against its normal n. */
static int
is_twisted(Chart g, const double *const phi[3], int i, int j, const double n[3])
{
	size_t p[4];
	double m[3];
	int k;

	nodes(g, i, j, p);
	for (k = 0; k < 4; k++) {
		cross_nodes(phi, p[(k+1)%4], p[k], p[(k+3)%4], p[k], m);
		if (!(dot3(n, m) > 0))
			return 1;
	}
	return 0;
}

static int
is_folded(Chart g, const double *const phi[3], int i, int j)
{
	static const int beside[4][2] = { { 1, 0 }, { -1, 0 }, { 0, 1 }, { 0, -1 } };
	double n[3], m[3];
	int k;

	normal(g, phi, i, j, n);
	if (is_twisted(g, phi, i, j, n))
		return 1;
	for (k = 0; k < 4; k++) {
		if (!is_cell(g, i + beside[k][0], j + beside[k][1]))
			continue;
		normal(g, phi, i + beside[k][0], j + beside[k][1], m);
		if (!(dot3(n, m) > 0))
			return 1;
	}
	return 0;
}

int
fold_mark(Chart g, const double *const phi[3], int radius, unsigned char *folded)
{
	Range u = stencil_apart(g, 0, radius), v = stencil_apart(g, 1, radius);
	int i, j, count = 0;

	memset(folded, 0, (size_t)g.nu*g.nv);
#pragma omp parallel for schedule(static) private(i) reduction(+:count)
	for (j = 0; j < g.nv; j++)
		for (i = 0; i < g.nu; i++) {
			int apart = (g.kind->joined[0][0] || (i >= u.from && i < u.to - 1)) && j >= v.from && j < v.to - 1;

			if (apart || !is_cell(g, i, j) || !is_folded(g, phi, i, j))
				continue;
			folded[(size_t)j*g.nu + i] = 1;
			count++;
		}
	return count;
}
