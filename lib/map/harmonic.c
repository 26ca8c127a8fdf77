/* harmonic.c - discrete harmonic functions between two sides. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "harmonic.h"

void
harmonic_sides(const Disk *d, const int corner[4], unsigned char *side)
{
	int k, i;

	memset(side, 0, d->m.nv);
	for (k = 0; k < 4; k++)
		for (i = corner[k]; ; i = (i + 1)%d->nb) {
			side[d->loop[i]] |= 1 << k;
			if (i == corner[(k+1)%4])
				break;
		}
}

void
harmonic_diagonal(Harmonic *h)
{
	int i, k;

	for (i = 0; i < h->g->n; i++)
		for (h->diagonal[i] = 0, k = h->g->first[i]; k < h->g->first[i+1]; k++)
			h->diagonal[i] -= h->off[k];
}

/* x_f = -A_fs x_s, where f are the free vertices and s the held ones, whose values are in x.  On
 * entry x_f is 0. */
static void
right_hand_side(const Harmonic *h, const unsigned char *held, double *x)
{
	const Graph *g = h->g;
	int i, k;

	for (i = 0; i < g->n; i++)
		for (k = g->first[i]; held[i] && k < g->first[i+1]; k++)
			if (!held[g->adj[k]])
				x[g->adj[k]] -= h->off[k]*x[i];
}

int
harmonic_solve(Harmonic *h, int zero, int one, double *x, SpdReport *report)
{
	int i, e, n = h->g->n;
	unsigned char *held = malloc(n);
	CholMatrix a = { h->diagonal, h->off, held };

	if (!held)
		return SPD_ENOMEM;
	for (i = 0; i < n; i++) {
		held[i] = (h->side[i] & (zero | one)) != 0;
		x[i] = (h->side[i] & one) != 0;
	}
	right_hand_side(h, held, x);
	e = chol_solve(&h->chol, &a, x, &report->column);
	for (i = 0; !e && i < n; i++)
		if (!isfinite(x[i])) {
			report->column = i;
			e = CHOL_EINDEFINITE;
		}
	free(held);
	return e == CHOL_ENOMEM ? SPD_ENOMEM : e ? SPD_EINDEFINITE : 0;
}
