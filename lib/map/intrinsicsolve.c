/* intrinsicsolve.c - the harmonic functions of an embeddable triangulation. */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "harmonic.h"
#include "intrinsicmatrix.h"
#include "intrinsicsolve.h"

enum { STRAIGHTENED = 6 };              /* solves with quadratic elements, at most */
static const double FLAT = 1e-14;       /* areas up to this share of the rectangle are 0 up to rounding */

/* By the maximum principle x is 0 or 1 on the two held sides only.  If rounding puts x outside the open
 * interval (0,1) at another vertex, replaces it by the nearest number inside. */
static void
keep_inside(int n, const unsigned char *side, int held, double *x)
{
	int i;

	for (i = 0; i < n; i++)
		if (!(side[i] & held))
			x[i] = fmin(fmax(x[i], DBL_MIN), 1 - DBL_EPSILON);
}

static int
solve(const IntrinsicMatrix *a, const unsigned char *side, double *u, double *v,
	SpdReport *report)
{
	Harmonic h = { .g = &a->g, .off = a->off, .side = side };
	int *order = malloc(a->g.n*sizeof *order), e;

	h.diagonal = malloc(a->g.n*sizeof *h.diagonal);
	e = !order || !h.diagonal || order_graph(&a->g, order) || chol_init(&h.chol, &a->g, order)
	    ? SPD_ENOMEM : 0;
	report->bytes = chol_bytes(&h.chol);
	if (!e)
		e = harmonic_pair(&h, u, v, report);
	if (!e) {
		keep_inside(a->g.n, side, SIDE_LEFT | SIDE_RIGHT, u);
		keep_inside(a->g.n, side, SIDE_BOTTOM | SIDE_TOP, v);
	}
	chol_free(&h.chol);
	free(h.diagonal);
	free(order);
	return e;
}

/* T, the certificate and v from the energies and v1, which m->v holds. */
static int
finish(IntrinsicMap *m, double Eu, double Ev)
{
	return harmonic_modulus(Eu, Ev, m->s.t.nv, m->v, &m->T, &m->certificate);
}

static int
count_turned(const IntrinsicMap *m)
{
	int f, turned = 0;

	for (f = 0; f < m->s.t.nf; f++)
		turned += mesh_image(&m->s.t.from[3*f], m->u, m->v) < -FLAT*m->T;
	return turned;
}

/* Solves for u and v1: by linear elements, at the vertices, if m is NULL; else by quadratic
 * elements, at vertices and midpoints. */
static int
solve_pair(const IntrinsicMap *map, const Middles *m, double *u, double *v, SpdReport *report)
{
	const Intrinsic *t = &map->s.t;
	unsigned char *side = malloc(m ? m->n : t->nv);
	IntrinsicMatrix a;
	int e = side ? (m ? intrinsic_quadratic(t, m, &a) : intrinsic_linear(t, &a)) : SPD_ENOMEM;

	if (!e) {
		harmonic_sides(&map->s.mesh.d, map->s.corner, side);
		if (m)
			intrinsic_middle_sides(t, m, side);
		e = solve(&a, side, u, v, report);
		intrinsic_matrix_free(&a);
	}
	if (!e && m) {
		intrinsic_middle_values(t, m, u);
		intrinsic_middle_values(t, m, v);
	}
	free(side);
	return e;
}

int
intrinsic_solve(IntrinsicMap *m, SpdReport *report)
{
	int e;

	free(m->u);
	free(m->v);
	m->u = malloc(m->s.t.nv*sizeof *m->u);
	m->v = malloc(m->s.t.nv*sizeof *m->v);
	e = m->u && m->v ? solve_pair(m, NULL, m->u, m->v, report) : SPD_ENOMEM;
	if (!e)
		e = finish(m, intrinsic_energy(&m->s.t, m->u), intrinsic_energy(&m->s.t, m->v));
	if (!e)
		m->turned = count_turned(m);
	return e;
}

/* Makes the edges of turned and flat triangles straight, and, as one more ring, those of triangles
 * that have a straight edge already. */
static void
straighten(const IntrinsicMap *m, unsigned char *straight, unsigned char *before)
{
	const int *edge = m->s.t.edge;
	int f, k;

	memcpy(before, straight, m->s.t.ne);
	for (f = 0; f < m->s.t.nf; f++) {
		const int *e = &edge[3*f];
		int more = before[e[0]] || before[e[1]] || before[e[2]]
		    || !(mesh_image(&m->s.t.from[3*f], m->u, m->v) > 0);

		for (k = 0; k < 3 && more; k++)
			straight[e[k]] = 1;
	}
}

/* Solves with quadratic elements.  Some of their weights are negative, so triangles may turn over.
 * Where all edges are straight, no weight is negative.  So edges round turned triangles are made
 * straight, ring by ring. */
static int
solve_straightened(IntrinsicMap *q, unsigned char *straight, Middles *m, SpdReport *report)
{
	unsigned char *before = malloc(q->s.t.ne);
	int k, e = before ? 0 : SPD_ENOMEM;

	q->turned = 1;
	for (k = 0; !e && k < STRAIGHTENED && q->turned > 0; k++) {
		intrinsic_middles(&q->s.t, straight, m);
		e = solve_pair(q, m, q->u, q->v, report);
		if (!e)
			e = finish(q, intrinsic_quadratic_energy(&q->s.t, q->u), intrinsic_quadratic_energy(&q->s.t, q->v));
		if (!e) {
			q->turned = count_turned(q);
			straighten(q, straight, before);
		}
	}
	free(before);
	return e;
}

int
intrinsic_solve_quadratic(IntrinsicMap *map, SpdReport *report)
{
	size_t n = map->s.t.nv + (size_t)map->s.t.ne;
	unsigned char *straight = calloc(map->s.t.ne, 1);
	Middles m = { malloc(map->s.t.ne*sizeof *m.unknown), 0 };
	IntrinsicMap q = *map;
	int e = SPD_ENOMEM;

	q.u = malloc(n*sizeof *q.u);
	q.v = malloc(n*sizeof *q.v);
	if (straight && m.unknown && q.u && q.v)
		e = solve_straightened(&q, straight, &m, report);
	free(straight);
	free(m.unknown);
	if (e || q.turned > 0 || !(q.certificate < map->certificate)) {
		free(q.u);
		free(q.v);
		return e == SPD_ENOMEM ? e : 0;
	}
	free(map->u);
	free(map->v);
	*map = q;
	map->quadratic = 1;
	return 0;
}
