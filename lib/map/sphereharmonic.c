/* sphereharmonic.c - dipole, and alternating harmonic functions. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../intrinsic/flips.h"
#include "../intrinsic/mollify.h"
#include "../base/vec3.h"
#include "cotangent.h"
#include "intrinsicmatrix.h"
#include "sphereface.h"
#include "sphereharmonic.h"
#include "sphereplace.h"

static const double FREE = 0.75;        /* share of the vertices that are free in a half round */

/* ---- the matrix ------------------------------------------------------ */

static int
cotangent_matrix(SphereHarmonic *s, const Disk *coarse)
{
	Cotangent C, C0;
	int e = cotangent_init(&C, s->d);

	if (!e && coarse && !(e = cotangent_init(&C0, coarse))) {
		e = cotangent_quadratic(&C, &C0);
		cotangent_free(&C0);
		if (e)
			cotangent_free(&C);
	}
	if (!e) {
		s->g = C.g;
		s->off = C.c;
	}
	return e;
}

static int
intrinsic_matrix(SphereHarmonic *s)
{
	Intrinsic t;
	IntrinsicMatrix a;
	int e = intrinsic_init(&t, s->d);

	if (e)
		return e;
	e = intrinsic_mollify(&t) || intrinsic_delaunay(&t, NULL) || intrinsic_linear(&t, &a);
	intrinsic_free(&t);
	if (!e) {
		s->g = a.g;
		s->off = a.off;
	}
	return e;
}

static void
set_diagonal(SphereHarmonic *s)
{
	int i, k;

	for (i = 0; i < s->g.n; i++)
		for (s->diagonal[i] = 0, k = s->g.first[i]; k < s->g.first[i+1]; k++)
			s->diagonal[i] -= s->off[k];
}

int
sphereharmonic_init(SphereHarmonic *s, const Disk *d, int elements, const Disk *coarse)
{
	int n = d->m.nv, *order = malloc(n*sizeof *order), e;

	*s = (SphereHarmonic){ .d = d, .diagonal = malloc(n*sizeof *s->diagonal), .x = malloc(n*sizeof *s->x),
	    .held = malloc(n), .z = malloc(n*sizeof *s->z) };
	e = !order || !s->diagonal || !s->x || !s->held || !s->z;
	if (!e)
		e = elements == SPHEREHARMONIC_INTRINSIC ? intrinsic_matrix(s)
		    : cotangent_matrix(s, elements == SPHEREHARMONIC_QUADRATIC ? coarse : NULL);
	if (!e && !(e = order_graph(&s->g, order)))
		e = chol_init(&s->chol, &s->g, order);
	free(order);
	if (!e)
		set_diagonal(s);
	else
		sphereharmonic_free(s);
	return e ? SPD_ENOMEM : 0;
}

void
sphereharmonic_free(SphereHarmonic *s)
{
	chol_free(&s->chol);
	free(s->g.first);
	free(s->g.adj);
	free(s->off);
	free(s->diagonal);
	free(s->x);
	free(s->held);
	free(s->z);
}

/* ---- solutions ------------------------------------------------------- */

/* Solves for s->x, the right-hand side, with the held vertices given: part 0 with a new factor, part 1 with the same
 * matrix once more. */
static int
solve(SphereHarmonic *s, int part, SpdReport *report)
{
	CholMatrix a = { s->diagonal, s->off, s->held };
	const Graph *g = &s->g;
	int i, k, e;

	for (i = 0; i < g->n; i++)
		for (k = g->first[i]; s->held[i] && k < g->first[i+1]; k++)
			if (!s->held[g->adj[k]])
				s->x[g->adj[k]] -= s->off[k]*s->x[i];
	e = part ? chol_again(&s->chol, s->x) : chol_solve(&s->chol, &a, s->x, &report->column);
	for (i = 0; !e && i < g->n; i++)
		if (!isfinite(s->x[i])) {
			report->column = i;
			e = CHOL_EINDEFINITE;
		}
	return e == CHOL_ENOMEM ? SPD_ENOMEM : e ? SPD_EINDEFINITE : 0;
}

/* Makes s->z harmonic at the vertices that are not held. */
static int
fill(SphereHarmonic *s, SpdReport *report)
{
	int part, i, e = 0;

	for (part = 0; !e && part < 2; part++) {
		for (i = 0; i < s->g.n; i++)
			s->x[i] = !s->held[i] ? 0 : part ? cimag(s->z[i]) : creal(s->z[i]);
		e = solve(s, part, report);
		for (i = 0; !e && i < s->g.n; i++)
			if (!s->held[i])
				s->z[i] = part ? CMPLX(creal(s->z[i]), s->x[i]) : CMPLX(s->x[i], 0);
	}
	return e;
}

static int
rising(const void *a, const void *b)
{
	double x = *(const double *)a, y = *(const double *)b;

	return (x > y) - (x < y);
}

/* Replaces z by 1/z, and makes it harmonic but at the vertices where it is largest. */
static int
half_round(SphereHarmonic *s, SpdReport *report)
{
	int n = s->g.n, i;
	double bound;

	for (i = 0; i < n; i++) {
		s->z[i] = s->z[i] == 0 ? SPHEREPLACE_FAR : 1/s->z[i];
		s->x[i] = cabs(s->z[i]);
	}
	qsort(s->x, n, sizeof *s->x, rising);
	bound = s->x[(int)(FREE*n)];
	for (i = 0; i < n; i++)
		s->held[i] = cabs(s->z[i]) > bound;
	return fill(s, report);
}

int
sphereharmonic_alternate(SphereHarmonic *s, int times, SpdReport *report)
{
	int k, e = 0;

	for (k = 0; !e && k < times; k++)
		e = half_round(s, report);
	return e;
}

/* ---- the start ------------------------------------------------------- */

static int
largest_face(const Mesh *m)
{
	int t, at = 0;
	double most = -1, area;

	for (t = 0; t < m->nf; t++) {
		area = sphereface_area2(m, t);
		if (area > most) {
			most = area;
			at = t;
		}
	}
	return at;
}

int
sphereharmonic_dipole(SphereHarmonic *s, SpdReport *report)
{
	const Mesh *m = &s->d->m;
	const int *c = &m->tri[3*(size_t)largest_face(m)];
	double a[3], b[3], n[3], length, x, height;
	int part, i, e = 0;

	sub3(&m->xyz[3*(size_t)c[1]], &m->xyz[3*(size_t)c[0]], a);
	sub3(&m->xyz[3*(size_t)c[2]], &m->xyz[3*(size_t)c[0]], b);
	cross3(a, b, n);
	length = norm3(a), x = dot3(a, b)/length, height = norm3(n)/length;
	memset(s->held, 0, m->nv);
	s->held[c[0]] = 1;
	for (part = 0; !e && part < 2; part++) {
		memset(s->x, 0, m->nv*sizeof *s->x);
		s->x[c[1]] = part ? x/(length*height) : 1/length;
		s->x[c[2]] = part ? -1/height : 0;
		e = solve(s, part, report);
		for (i = 0; !e && i < m->nv; i++)
			s->z[i] = part ? CMPLX(creal(s->z[i]), s->x[i]) : CMPLX(s->x[i], 0);
	}
	if (!e)
		e = sphereplace_centre(m, s->z);
	if (!e)
		sphereplace_orient(m, s->z);
	return e;
}
