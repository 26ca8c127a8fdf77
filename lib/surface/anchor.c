/* anchor.c - moves a surface into place rigidly. */
#include <stdlib.h>
#include <string.h>

#include "anchor.h"
#include "../base/procrustes.h"
#include "../grid/stencil.h"

static void
gather(size_t count, const size_t *node, size_t n, const double *phi, double *x)
{
	size_t q;
	int c;

	for (q = 0; q < count; q++)
		for (c = 0; c < 3; c++)
			x[3*q+c] = phi[c*n + node[q]];
}

int
anchor_init(Anchor *a, Chart g, int border, const double *weight, const double *phi)
{
	size_t n = (size_t)g.nu*g.nv, p;
	size_t most = border ? 2*((size_t)g.nu + g.nv) : n;

	*a = (Anchor){ .node = malloc(most*sizeof *a->node), .at = malloc(3*most*sizeof *a->at),
	    .weight = weight ? malloc(most*sizeof *a->weight) : NULL };
	if (!a->node || !a->at || (weight && !a->weight)) {
		anchor_free(a);
		return ANCHOR_ENOMEM;
	}
	for (p = 0; p < n; p++) {
		int i = (int)(p%g.nu), j = (int)(p/g.nu);

		if (border && stencil_is_inner(g, i, j))
			continue;
		if (weight)
			a->weight[a->n] = weight[p];
		a->node[a->n++] = p;
	}
	gather(a->n, a->node, n, phi, a->at);
	return 0;
}

void
anchor_free(Anchor *a)
{
	free(a->node);
	free(a->at);
	free(a->weight);
	memset(a, 0, sizeof *a);
}

int
anchor_place(const Anchor *a, Chart g, double *phi)
{
	size_t n = (size_t)g.nu*g.nv, p;
	double *x = malloc(3*a->n*sizeof *x), rms;
	Rigid r;
	int c, e;

	if (!x)
		return ANCHOR_ENOMEM;
	gather(a->n, a->node, n, phi, x);
	e = procrustes((int)a->n, a->weight, a->at, x, &r, &rms);
	free(x);
	for (p = 0; !e && p < n; p++) {
		double y[3] = { phi[p], phi[n+p], phi[2*n+p] };

		rigid_move(&r, 1, y);
		for (c = 0; c < 3; c++)
			phi[c*n+p] = y[c];
	}
	return e ? ANCHOR_EVALUE : 0;
}
