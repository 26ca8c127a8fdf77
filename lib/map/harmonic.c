/* harmonic.c - discrete harmonic functions between two sides. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "harmonic.h"

static const double STEEP = 1e6;        /* weights are about 1 where triangles are well shaped; in a
                                         * diagonal this large they have ten digits left */

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

/* Whether some row has entries so large that others lose digits in its diagonal. */
static int
is_steep(const Harmonic *h)
{
	int i;

	for (i = 0; i < h->g->n && h->diagonal[i] < STEEP; i++)
		;
	return i < h->g->n;
}

/* r = -A x at the free vertices, 0 at the held ones.  As rows sum to 0, differences of x will do; the
 * diagonal and its rounding errors are not needed. */
static void
residual(const Harmonic *h, const unsigned char *held, const double *x, double *r)
{
	const Graph *g = h->g;
	int i, k;

	for (i = 0; i < g->n; i++)
		for (r[i] = 0, k = g->first[i]; !held[i] && k < g->first[i+1]; k++)
			r[i] -= h->off[k]*(x[g->adj[k]] - x[i]);
}

/* One step of iterative refinement: adds to x the solution of A d = r. */
static int
refine(Harmonic *h, const CholMatrix *a, double *x, int *at)
{
	int i, e, n = h->g->n;
	double *d = malloc(n*sizeof *d);

	if (!d)
		return CHOL_ENOMEM;
	residual(h, a->held, x, d);
	e = chol_solve(&h->chol, a, d, at);
	for (i = 0; !e && i < n; i++)
		x[i] += d[i];
	free(d);
	return e;
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
	if (!e && is_steep(h))
		e = refine(h, &a, x, &report->column);
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
