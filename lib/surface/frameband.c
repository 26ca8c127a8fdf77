/* frameband.c - frame and second fundamental form of a given surface. */
#include "frame.h"
#include "frameband.h"
#include "../base/vec3.h"
#include "../grid/stencil.h"

/* Frame and second form of phi at inner node (i,j).                                  (12) */
static int
node_of_band(Chart g, const double *const phi[3], int i, int j, double pqn[9], double DM[2])
{
	double *p = pqn, *q = pqn + 3, *n = pqn + 6, uu[3], uv[3], vv[3], L = 0, M = 0, N = 0, area;
	int c;

	stencil_tangents(g, phi, i, j, p, q);
	stencil_second_form(g, phi, i, j, uu, uv, vv);
	cross3(p, q, n);
	area = norm3(n);
	if (!(area > 0))
		return FRAME_EBAND;
	for (c = 0; c < 3; c++) {
		n[c] /= area;
		L += uu[c]*n[c];
		M += uv[c]*n[c];
		N += vv[c]*n[c];
	}
	DM[0] = (L - N)/2;
	DM[1] = M;
	return 0;
}

int
frameband(Chart g, const double *const phi[3], double x, double y, int *at, double pqn[9], double DM[2])
{
	int i = (int)x, j = (int)y, k, c;
	double node[11], w;

	for (c = 0; c < 11; c++)
		*(c < 9 ? pqn + c : DM + c - 9) = 0;
	for (k = 0; k < 4; k++) {
		w = (k%2 ? x - i : 1 - (x - i))*(k/2 ? y - j : 1 - (y - j));
		if (!(w > 0))
			continue;
		*at = (j + k/2)*g.nu + i + k%2;
		if (node_of_band(g, phi, i + k%2, j + k/2, node, node + 9))
			return FRAME_EBAND;
		for (c = 0; c < 11; c++)
			*(c < 9 ? pqn + c : DM + c - 9) += w*node[c];
	}
	return 0;
}
