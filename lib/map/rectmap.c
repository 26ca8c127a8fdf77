/* rectmap.c - two harmonic functions from one symbolic factorization, and the modulus. */
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "harmonic.h"
#include "rectmap.h"

enum { NUMBERS = 40 };  /* doubles per vertex for matrix and elimination order, about */

/* The data shared by the systems for u and v1. */
typedef struct System {
	Cotangent      C;
	Harmonic       h;
	unsigned char *side;
} System;

static void
release(System *s)
{
	chol_free(&s->h.chol);
	free(s->h.diagonal);
	cotangent_free(&s->C);
	free(s->side);
}

/* The matrix of quadratic elements on `coarse`; d is coarse with all triangles split into four. */
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

/* Does the symbolic factorization and, if `values`, at the same time computes the entries of the
 * matrix. */
static int
plan(const Disk *d, int values, System *s, const int *order)
{
	int e;

#pragma omp parallel sections
	{
#pragma omp section
		e = chol_init(&s->h.chol, &s->C.g, order);
#pragma omp section
		if (values)
			cotangent_values(&s->C, d);
	}
	return e;
}

/* The matrix and its symbolic factorization: of quadratic elements on coarse, or, if coarse is
 * NULL, of linear elements on d. */
static int
prepare(const Disk *d, const Disk *coarse, const int corner[4], System *s)
{
	int *order = malloc(d->m.nv*sizeof *order), e;

	memset(s, 0, sizeof *s);
	s->h.diagonal = malloc(d->m.nv*sizeof *s->h.diagonal);
	s->side = malloc(d->m.nv);
	e = !order || !s->h.diagonal || !s->side
	    || (coarse ? quadratic(d, coarse, &s->C) : cotangent_graph(&s->C, d))
	    || order_graph(&s->C.g, order);
	if (!e)
		e = plan(d, !coarse, s, order);
	free(order);
	if (e)
		return SPD_ENOMEM;
	s->h.g = &s->C.g;
	s->h.off = s->C.c;
	s->h.side = s->side;
	harmonic_sides(d, corner, s->side);
	return 0;
}

/* u and v1, the map (4) before v1 is multiplied by T. */
static int
solve(const Disk *d, const Disk *coarse, const int corner[4], double *u, double *v,
	SpdReport *report)
{
	System s;
	int e = prepare(d, coarse, corner, &s);

	report->bytes = chol_bytes(&s.h.chol);
	if (!e)
		e = harmonic_pair(&s.h, u, v, report);
	release(&s);
	return e;
}

/* The Dirichlet energies of u and v, by the same elements as the matrix. */
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
	int e;

	memset(report, 0, sizeof *report);
	if (4*(size_t)d->m.nf + d->nb > INT_MAX)
		return SPD_ELARGE;
	e = solve(d, coarse, corner, u, v, report);
	if (!e)
		e = energy(d, coarse, u, v, &Eu, &Ev);
	if (e == SPD_ENOMEM && !(report->bytes > 0))
		report->bytes = NUMBERS*sizeof(double)*d->m.nv;
	return e ? e : harmonic_modulus(Eu, Ev, d->m.nv, v, T, certificate);
}

int
rectmap_flipped(const Mesh *m, const double *u, const double *v)
{
	int t, n = 0;

	for (t = 0; t < m->nf; t++)
		n += mesh_image(&m->tri[3*(size_t)t], u, v) < 0;
	return n;
}

int
rectmap_flat(const Mesh *m, const double *u, const double *v)
{
	int t, n = 0;

	for (t = 0; t < m->nf; t++)
		n += mesh_image(&m->tri[3*(size_t)t], u, v) == 0;
	return n;
}
