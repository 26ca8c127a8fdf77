/* fair.c - the systems K M^-1 K and K M^-1 K M^-1 K of patches, column by column. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/vec3.h"
#include "../mesh/fail.h"
#include "../sparse/spd.h"
#include "area.h"
#include "fair.h"

/* The operators, and a sparse vector that they are applied to: x[touched[0..n-1]] may differ from 0. */
typedef struct Operator {
	const Sheet *s;
	int    *first, *corner;
	double *half;           /* [3*nf] half the cotangent opposite to each side, times -1 */
	double *inverse;        /* [nv] of M, 0 on the boundary */
	double *x, *y;          /* [nv] */
	int    *touched, *reached, n;
	unsigned char *is_touched;
} Operator;

/* Half the cotangents of face f, at the sides opposite to its corners.  Faces without area have no
 * part in the sum. */
static void
enter_face(const Sheet *s, int f, double *half)
{
	const int *t = s->tri + 3*(size_t)f;
	double a[3], b[3], n[3], twice;
	int k;

	for (k = 0; k < 3; k++) {
		sub3(sheet_at(s, t[(k+1)%3]), sheet_at(s, t[k]), a);
		sub3(sheet_at(s, t[(k+2)%3]), sheet_at(s, t[k]), b);
		cross3(a, b, n);
		twice = 2*norm3(n);
		half[3*(size_t)f + (size_t)(k+1)%3] = twice > 0 ? -dot3(a, b)/twice : 0;
	}
}

static void
enter_areas(Operator *o)
{
	const Sheet *s = o->s;
	int f, k, i;

	memset(o->inverse, 0, (size_t)s->nv*sizeof *o->inverse);
	for (f = 0; f < s->nf; f++)
		for (k = 0; k < 3; k++)
			o->inverse[s->tri[3*(size_t)f + (size_t)k]] += sheet_area(s, f)/3;
	for (i = 0; i < s->nv; i++)
		o->inverse[i] = o->inverse[i] > 0 ? 1/o->inverse[i] : 0;
	for (i = 0; i < 3*s->nf; i++)
		if (s->twin[i] < 0)
			o->inverse[s->tri[i]] = o->inverse[sheet_to(s, i)] = 0;
}

static void
operator_free(Operator *o)
{
	free(o->first);
	free(o->corner);
	free(o->half);
	free(o->inverse);
	free(o->x);
	free(o->y);
	free(o->touched);
	free(o->reached);
	free(o->is_touched);
}

static int
operator_init(Operator *o, const Sheet *s)
{
	const size_t nv = (size_t)s->nv;
	int f;

	memset(o, 0, sizeof *o);
	o->s = s;
	if (sheet_corners(s->tri, 3*s->nf, s->nv, &o->first, &o->corner, s->err))
		return MESH_ENOMEM;
	o->half = mesh_alloc(s->err, 3*(size_t)s->nf, sizeof *o->half);
	o->inverse = mesh_alloc(s->err, nv, sizeof *o->inverse);
	o->x = mesh_alloc(s->err, nv, sizeof *o->x);
	o->y = mesh_alloc(s->err, nv, sizeof *o->y);
	o->touched = mesh_alloc(s->err, nv, sizeof *o->touched);
	o->reached = mesh_alloc(s->err, nv, sizeof *o->reached);
	o->is_touched = mesh_alloc(s->err, nv, 1);
	if (!o->half || !o->inverse || !o->x || !o->y || !o->touched || !o->reached || !o->is_touched) {
		operator_free(o);
		return MESH_ENOMEM;
	}
	memset(o->x, 0, nv*sizeof *o->x);
	memset(o->y, 0, nv*sizeof *o->y);
	memset(o->is_touched, 0, nv);
	for (f = 0; f < s->nf; f++)
		enter_face(s, f, o->half);
	enter_areas(o);
	return 0;
}

static void
reach(Operator *o, int v, double add, int *n)
{
	if (!o->is_touched[v]) {
		o->is_touched[v] = 1;
		o->reached[(*n)++] = v;
	}
	o->y[v] += add;
}

/* Adds x[v] times the column of K at v from one face, c being the corner at v. */
static void
add_face(Operator *o, int c, double x, int *n)
{
	const int next = sheet_next(c), prev = sheet_prev(c);
	const double after = o->half[c], before = o->half[prev];        /* of the sides c, prev */

	reach(o, o->s->tri[c], -(after + before)*x, n);
	reach(o, o->s->tri[next], after*x, n);
	reach(o, o->s->tri[prev], before*x, n);
}

/* Whether a corner of the face is on the boundary. */
static int
on_boundary(const Operator *o, int c)
{
	const int f = c - c%3;

	return o->inverse[o->s->tri[f]] == 0 || o->inverse[o->s->tri[f+1]] == 0 ||
	    o->inverse[o->s->tri[f+2]] == 0;
}

/* x = K x, without the triangles at the boundary if inner is not 0. */
static void
apply_K(Operator *o, int inner)
{
	double *swap;
	int *list, i, k, n = 0;

	for (i = 0; i < o->n; i++)
		for (k = o->first[o->touched[i]]; k < o->first[o->touched[i] + 1]; k++)
			if (!inner || !on_boundary(o, o->corner[k]))
				add_face(o, o->corner[k], o->x[o->touched[i]], &n);
	for (i = 0; i < o->n; i++)
		o->x[o->touched[i]] = 0;
	for (i = 0; i < n; i++)
		o->is_touched[o->reached[i]] = 0;
	swap = o->x, o->x = o->y, o->y = swap;
	list = o->touched, o->touched = o->reached, o->reached = list;
	o->n = n;
}

static void
apply_inverse_M(Operator *o)
{
	int i;

	for (i = 0; i < o->n; i++)
		o->x[o->touched[i]] *= o->inverse[o->touched[i]];
}

/* x = the column of the system at vertex v. */
static void
column(Operator *o, int v, int order)
{
	int i;

	for (i = 0; i < o->n; i++)
		o->x[o->touched[i]] = 0;
	o->n = 1;
	o->touched[0] = v;
	o->x[v] = 1;
	apply_K(o, 0);
	apply_inverse_M(o);
	if (order == FAIR_C2) {
		apply_K(o, 1);
		apply_inverse_M(o);
	}
	apply_K(o, 0);
}

/* The number of entries in the lower triangle of the rows and columns from `from` on. */
static size_t
count_entries(Operator *o, int from, int order)
{
	size_t n = 0;
	int v, i;

	for (v = from; v < o->s->nv; v++) {
		column(o, v, order);
		for (i = 0; i < o->n; i++)
			n += o->touched[i] >= v;
	}
	return n;
}

/* Assembles the matrix a of the free vertices.  Sets the right-hand sides B to minus the columns of the
 * held vertices times the positions of these, measured from vertex 0: far from the origin of the
 * coordinates their sums would be lost in rounding. */
static void
assemble(Operator *o, int from, int order, Spd *a, double *B)
{
	const size_t n = (size_t)(o->s->nv - from);
	int v, i, c;

	memset(B, 0, 3*n*sizeof *B);
	for (v = from; v < o->s->nv; v++) {
		column(o, v, order);
		for (i = 0; i < o->n; i++) {
			const int w = o->touched[i];

			if (w >= v)
				spd_add(a, w - from, v - from, o->x[w]);
			for (c = 0; w < from && c < 3; c++)
				B[(size_t)c*n + (size_t)(v - from)] -= o->x[w]*(sheet_at(o->s, w)[c] - sheet_at(o->s, 0)[c]);
		}
	}
}

/* Returns 0, MESH_ENOMEM, or SPD_EINDEFINITE. */
static int
solve(Sheet *s, Operator *o, int from, int order)
{
	const size_t n = (size_t)(s->nv - from);
	double *B = mesh_alloc(s->err, 3*n, sizeof *B);
	size_t v;
	int e, c;
	Spd a;

	if (!B)
		return MESH_ENOMEM;
	if ((e = spd_init(&a, (int)n, count_entries(o, from, order))) == 0) {
		assemble(o, from, order, &a, B);
		e = spd_solve(&a, NULL, 3, B, NULL);
	}
	for (v = 0; !e && v < n; v++)
		for (c = 0; c < 3; c++)
			s->xyz[3*((size_t)from + v) + (size_t)c] = sheet_at(s, 0)[c] + B[(size_t)c*n + v];
	free(B);
	return e == 0 || e == SPD_EINDEFINITE ? e : mesh_fail(s->err, MESH_ENOMEM,
	    "no memory to fair %zu vertices", n);
}

int
fair(Sheet *s, int from, int order)
{
	Operator o;
	int e = 0;

	if (from == s->nv)
		return order;
	if (operator_init(&o, s))
		return MESH_ENOMEM;
	for (; order > FAIR_FLAT && (e = solve(s, &o, from, order)) == SPD_EINDEFINITE; order--)
		continue;
	operator_free(&o);
	return e == MESH_ENOMEM ? e : order;
}
