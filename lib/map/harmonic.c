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

static void
set_diagonal(Harmonic *h)
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

/* Solves for x, which is 0 on the sides `zero` and 1 on the sides `one` (bits). */
static int
solve(Harmonic *h, int zero, int one, double *x, SpdReport *report)
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

int
harmonic_pair(Harmonic *h, double *u, double *v1, SpdReport *report)
{
	int e;

	set_diagonal(h);
	e = solve(h, SIDE_LEFT, SIDE_RIGHT, u, report);
	return e ? e : solve(h, SIDE_BOTTOM, SIDE_TOP, v1, report);
}

int
harmonic_modulus(double Eu, double Ev, int n, double *v, double *T, double *certificate)
{
	int i;

	if (!(Eu > 0 && Eu < HUGE_VAL && Ev > 0 && Ev < HUGE_VAL))
		return SPD_EINDEFINITE;
	*T = sqrt(Eu/Ev);                               /* (6) */
	*certificate = sqrt(Eu*Ev) - 1;
	for (i = 0; i < n; i++)
		v[i] *= *T;                             /* (4) */
	return 0;
}
