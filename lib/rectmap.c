/* rectmap.c - the two harmonic functions and the modulus. */
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "rectmap.h"

enum { NUMBERS = 40 };  /* per vertex that the matrices and their order take, about */

/* One of the two systems, C_ff x_f = -C_fs x_s for the free vertices f and those on the
 * sides, s.  Free vertices are numbered in the order of their elimination. */
typedef struct Harmonic {
	double    *x;           /* [nv] 0 at free vertices, until they are known */
	int       *number;      /* [nv] of free vertices, -1 on the sides */
	SpdColumns a;
	double    *b;           /* [a.n] */
} Harmonic;

/* Sets side vertices of the loop, from corner a to corner b, to a value. */
static void
hold(const Disk *d, int a, int b, double value, Harmonic *h)
{
	int i;

	for (i = a; ; i = (i + 1)%d->nb) {
		h->x[d->loop[i]] = value;
		h->number[d->loop[i]] = -1;
		if (i == b)
			break;
	}
}

/* Numbers the free vertices; returns how many entries their rows have at most below the
 * diagonal and on it: every edge once. */
static size_t
number_free(const Cotangent *C, const int *order, Harmonic *h)
{
	int k;

	for (h->a.n = 0, k = 0; k < C->g.n; k++)
		if (h->number[order[k]] >= 0)
			h->number[order[k]] = h->a.n++;
	return (size_t)C->g.first[C->g.n]/2 + h->a.n;
}

/* Column and right-hand side of free vertex i; returns where the next column starts. */
static int
column(const Cotangent *C, int i, Harmonic *h, int next)
{
	int k, j, p = h->number[i], diagonal = next++;
	double sum = 0;

	for (h->b[p] = 0, k = C->g.first[i]; k < C->g.first[i+1]; k++) {
		j = C->g.adj[k];
		sum -= C->c[k];
		if (h->number[j] < 0)
			h->b[p] -= C->c[k]*h->x[j];
		else if (h->number[j] > p) {
			h->a.row[next] = h->number[j];
			h->a.value[next++] = C->c[k];
		}
	}
	h->a.row[diagonal] = p;
	h->a.value[diagonal] = sum;
	return next;
}

static int
assemble(const Cotangent *C, const int *order, Harmonic *h)
{
	size_t room = number_free(C, order, h);
	int k, next = 0;

	h->a.first = malloc((h->a.n + (size_t)1)*sizeof *h->a.first);
	h->a.row = malloc(room*sizeof *h->a.row + 1);
	h->a.value = malloc(room*sizeof *h->a.value + 1);
	h->b = malloc(h->a.n*sizeof *h->b + 1);
	if (!h->a.first || !h->a.row || !h->a.value || !h->b)
		return SPD_ENOMEM;
	for (k = 0; k < C->g.n; k++)
		if (h->number[order[k]] >= 0) {
			h->a.first[h->number[order[k]]] = next;
			next = column(C, order[k], h, next);
		}
	h->a.first[h->a.n] = next;
	return 0;
}

static void
release(Harmonic *h)
{
	free(h->number);
	free(h->a.first);
	free(h->a.row);
	free(h->a.value);
	free(h->b);
}

/* Both systems, from the matrix and the order of its rows that they share. */
static int
assemble_pair(const Disk *d, Harmonic h[2])
{
	int *order = malloc(d->m.nv*sizeof *order), e[2] = { SPD_ENOMEM, SPD_ENOMEM }, k;
	Cotangent C;

	if (!order || cotangent_init(&C, d)) {
		free(order);
		return SPD_ENOMEM;
	}
	if (order_graph(&C.g, order) == 0) {
#pragma omp parallel for schedule(static, 1)
		for (k = 0; k < 2; k++)
			e[k] = assemble(&C, order, &h[k]);
	}
	cotangent_free(&C);
	free(order);
	return e[0] ? e[0] : e[1];
}

static int
solve_pair(const Disk *d, Harmonic h[2], SpdReport *report)
{
	const SpdColumns a[2] = { h[0].a, h[1].a };
	double *const b[2] = { h[0].b, h[1].b };
	int i, k, e = spd_solve_pair(a, b, report);

	for (k = 0; !e && k < 2; k++)
		for (i = 0; i < d->m.nv; i++)
			if (h[k].number[i] >= 0)
				h[k].x[i] = b[k][h[k].number[i]];
	return e;
}

/* u and v1. */
static int
harmonic_pair(const Disk *d, const int corner[4], double *u, double *v, SpdReport *report)
{
	Harmonic h[2] = { { .x = u }, { .x = v } };
	int k, e = SPD_ENOMEM;

	for (k = 0; k < 2; k++) {
		memset(h[k].x, 0, d->m.nv*sizeof *u);
		h[k].number = calloc(d->m.nv, sizeof *h[k].number);
	}
	if (h[0].number && h[1].number) {
		hold(d, corner[3], corner[0], 0, &h[0]);
		hold(d, corner[1], corner[2], 1, &h[0]);
		hold(d, corner[0], corner[1], 0, &h[1]);
		hold(d, corner[2], corner[3], 1, &h[1]);
		e = assemble_pair(d, h);
	}
	if (!e)
		e = solve_pair(d, h, report);
	release(&h[0]);
	release(&h[1]);
	return e;
}

int
rectmap(const Disk *d, const int corner[4], double *u, double *v, double *T,
	double *certificate, SpdReport *report)
{
	double Eu, Ev;
	int i, e;

	memset(report, 0, sizeof *report);
	if (3*(size_t)d->m.nf + d->nb > INT_MAX)
		return SPD_ELARGE;
	e = harmonic_pair(d, corner, u, v, report);
	if (!e && cotangent_energy(&d->m, u, v, &Eu, &Ev))
		e = SPD_ENOMEM;
	if (e == SPD_ENOMEM && !(report->bytes > 0))
		report->bytes = NUMBERS*sizeof(double)*d->m.nv;
	if (e)
		return e;
	if (!(Eu > 0 && Eu < HUGE_VAL && Ev > 0 && Ev < HUGE_VAL))
		return SPD_EINDEFINITE;
	*T = sqrt(Eu/Ev);
	*certificate = sqrt(Eu*Ev) - 1;
	for (i = 0; i < d->m.nv; i++)
		v[i] *= *T;
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
