/* rectmap.c - two harmonic functions from one symbolic factorization, and the modulus. */
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../sparse/chol.h"
#include "rectmap.h"

enum { NUMBERS = 40 };  /* per vertex, about: the matrix and its order */

/* C_ff x_f = -C_fs x_s for the free vertices f, with the values of the side vertices s given.
 * This part is shared by both systems. */
typedef struct Harmonic {
	Cotangent C;
	double   *diagonal;     /* [nv] */
	Chol      chol;
} Harmonic;

static void
release(Harmonic *h)
{
	chol_free(&h->chol);
	cotangent_free(&h->C);
	free(h->diagonal);
}

/* The matrix of quadratic elements on `coarse`; d is coarse with all triangles split. */
static int
quadratic(const Disk *d, const Disk *coarse, Cotangent *C)
{
	Cotangent C0;
	int e = cotangent_init(C, d);

	if (e)
		return e;
	e = cotangent_init(&C0, coarse);
	if (!e) {
		e = cotangent_quadratic(C, &C0);
		cotangent_free(&C0);
	}
	return e;
}

/* Symbolic factorization; at the same time, with `values`, the entries of the matrix. */
static int
plan(const Disk *d, int values, Harmonic *h, const int *order)
{
	int e;

#pragma omp parallel sections
	{
#pragma omp section
		e = chol_init(&h->chol, &h->C.g, order);
#pragma omp section
		if (values)
			cotangent_values(&h->C, d);
	}
	return e;
}

/* The matrix and the plan of its factor: of linear elements on d, or of quadratic ones on
 * coarse. */
static int
prepare(const Disk *d, const Disk *coarse, Harmonic *h)
{
	int *order = malloc(d->m.nv*sizeof *order), i, k, e;

	memset(h, 0, sizeof *h);
	h->diagonal = calloc(d->m.nv, sizeof *h->diagonal);
	e = !order || !h->diagonal || (coarse ? quadratic(d, coarse, &h->C) : cotangent_graph(&h->C, d))
	    || order_graph(&h->C.g, order);
	if (!e)
		e = plan(d, !coarse, h, order);
	for (i = 0; !e && i < d->m.nv; i++)
		for (k = h->C.g.first[i]; k < h->C.g.first[i+1]; k++)
			h->diagonal[i] -= h->C.c[k];
	free(order);
	return e ? SPD_ENOMEM : 0;
}

/* Sets the vertices of a side, from corner a to corner b of the loop, to a value. */
static void
set_side(const Disk *d, int a, int b, double value, double *x, unsigned char *held)
{
	int i;

	for (i = a; ; i = (i + 1)%d->nb) {
		x[d->loop[i]] = value;
		held[d->loop[i]] = 1;
		if (i == b)
			break;
	}
}

/* x_f = -C_fs x_s; x_f is 0 on entry. */
static void
right_hand_side(const Cotangent *C, const unsigned char *held, double *x)
{
	int i, k;

	for (i = 0; i < C->g.n; i++)
		for (k = C->g.first[i]; held[i] && k < C->g.first[i+1]; k++)
			if (!held[C->g.adj[k]])
				x[C->g.adj[k]] -= C->c[k]*x[i];
}

/* The harmonic x that is 0 on the side that begins at corner k and 1 on the opposite one. */
static int
solve(const Disk *d, const int corner[4], int k, Harmonic *h, double *x, SpdReport *report)
{
	unsigned char *held = calloc(d->m.nv, 1);
	CholMatrix a = { h->diagonal, h->C.c, held };
	int i, e;

	if (!held)
		return SPD_ENOMEM;
	memset(x, 0, d->m.nv*sizeof *x);
	set_side(d, corner[k], corner[(k+1)%4], 0, x, held);
	set_side(d, corner[(k+2)%4], corner[(k+3)%4], 1, x, held);
	right_hand_side(&h->C, held, x);
	e = chol_solve(&h->chol, &a, x, &report->column);
	for (i = 0; !e && i < d->m.nv; i++)
		if (!isfinite(x[i])) {
			report->column = i;
			e = CHOL_EINDEFINITE;
		}
	free(held);
	return e == CHOL_ENOMEM ? SPD_ENOMEM : e ? SPD_EINDEFINITE : 0;
}

/* u and v1, the map (4) before v1 is multiplied by T. */
static int
harmonic_pair(const Disk *d, const Disk *coarse, const int corner[4], double *u, double *v, SpdReport *report)
{
	Harmonic h;
	int e = prepare(d, coarse, &h);

	report->bytes = chol_bytes(&h.chol);
	if (!e)
		e = solve(d, corner, 3, &h, u, report);
	if (!e)
		e = solve(d, corner, 0, &h, v, report);
	release(&h);
	return e;
}

/* The Dirichlet energies, with the elements of the matrix. */
static int
energy(const Disk *d, const Disk *coarse, const double *u, const double *v, double *Eu, double *Ev)
{
	double Eu0, Ev0;

	if (cotangent_energy(&d->m, u, v, Eu, Ev))
		return SPD_ENOMEM;
	if (!coarse)
		return 0;
	if (cotangent_energy(&coarse->m, u, v, &Eu0, &Ev0))
		return SPD_ENOMEM;
	*Eu = (4**Eu - Eu0)/3;
	*Ev = (4**Ev - Ev0)/3;
	return 0;
}

int
rectmap(const Disk *d, const Disk *coarse, const int corner[4], double *u, double *v, double *T,
	double *certificate, SpdReport *report)
{
	double Eu, Ev;
	int i, e;

	memset(report, 0, sizeof *report);
	if (4*(size_t)d->m.nf + d->nb > INT_MAX)
		return SPD_ELARGE;
	e = harmonic_pair(d, coarse, corner, u, v, report);
	if (!e)
		e = energy(d, coarse, u, v, &Eu, &Ev);
	if (e == SPD_ENOMEM && !(report->bytes > 0))
		report->bytes = NUMBERS*sizeof(double)*d->m.nv;
	if (e)
		return e;
	if (!(Eu > 0 && Eu < HUGE_VAL && Ev > 0 && Ev < HUGE_VAL))
		return SPD_EINDEFINITE;
	*T = sqrt(Eu/Ev);                               /* (6) */
	*certificate = sqrt(Eu*Ev) - 1;
	for (i = 0; i < d->m.nv; i++)
		v[i] *= *T;                             /* (4) */
	return 0;
}

int
rectmap_flipped(const Mesh *m, const double *u, const double *v)
{
	int t, flipped = 0;

	for (t = 0; t < m->nf; t++) {
		int a = m->tri[3*t], b = m->tri[3*t+1], c = m->tri[3*t+2];

		flipped += (u[b] - u[a])*(v[c] - v[a]) - (u[c] - u[a])*(v[b] - v[a]) < 0;
	}
	return flipped;
}
