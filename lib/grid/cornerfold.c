/* cornerfold.c - cells that are turned over near the corners of a grid. */
#include "cornerfold.h"
#include "../base/vec3.h"

static int
is_right(int k)
{
	return k == 1 || k == 2;
}

int
corner_exists(Chart g, int k)
{
	return !g.kind->joined[0][is_right(k)] && !g.kind->joined[1][k >= 2];
}

int
corner_node(Chart g, int k, int a, int b)
{
	return (k >= 2 ? g.nv - 1 - b : b)*g.nu + (is_right(k) ? g.nu - 1 - a : a);
}

void
corner_cell_normal(Chart g, int k, const double *const phi[3], int a, int b, double n[3])
{
	double x[3], y[3];
	int c;

	for (c = 0; c < 3; c++) {
		x[c] = phi[c][corner_node(g, k, a + 1, b + 1)] - phi[c][corner_node(g, k, a, b)];
		y[c] = phi[c][corner_node(g, k, a, b + 1)] - phi[c][corner_node(g, k, a + 1, b)];
	}
	cross3(x, y, n);
}

int
corner_cell_folded(Chart g, int k, const double *const phi[3], int a, int b)
{
	static const int beside[4][2] = { { 1, 0 }, { -1, 0 }, { 0, 1 }, { 0, -1 } };
	double n[3], m[3];
	int i;

	corner_cell_normal(g, k, phi, a, b, n);
	for (i = 0; i < 4; i++) {
		if (a + beside[i][0] < 0 || b + beside[i][1] < 0)
			continue;
		corner_cell_normal(g, k, phi, a + beside[i][0], b + beside[i][1], m);
		if (!(dot3(n, m) > 0))
			return 1;
	}
	return 0;
}

int
corner_folds(Chart g, int k, const double *const phi[3], int radius)
{
	int a, b, folds = 0;

	for (b = 0; b < radius; b++)
		for (a = 0; a < radius; a++)
			folds += corner_cell_folded(g, k, phi, a, b);
	return folds;
}
