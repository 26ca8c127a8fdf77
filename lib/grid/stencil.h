/* stencil.h - finite differences on the nodes of a chart.
 *
 * Inner nodes are those that lie on no open side of the chart (chart.h); they have central
 * differences and the five-point Laplacian.  Neighbours beyond a joined side are defined by the
 * chart.  On an open side first differences are one-sided, and of second order, too.
 *
 * There are two versions of the differences: for one node, and for four nodes of a row at a time.
 * The first divides by the steps, the second multiplies by inverse steps, so their results differ in
 * the last bits.
 */
#ifndef STENCIL_H
#define STENCIL_H

#include <stddef.h>
#include <string.h>

#include "../base/chart.h"
#include "../base/cpu.h"

/* Nodes from .. to-1 along one axis. */
typedef struct Range {
	int from, to;
} Range;

/* The range, along u (axis 0) or v (axis 1), of the nodes at least `rings` steps from the open sides. */
Range  stencil_apart(Chart g, int axis, int rings);

/* The range of inner nodes along an axis: those one step from the open sides; the number of inner nodes of the grid; and
 * whether node (i,j) is an inner node. */
Range  stencil_inner(Chart g, int axis);
size_t stencil_inner_count(Chart g);
int    stencil_is_inner(Chart g, int i, int j);

/* The range, along an axis, of the places (i,j) whose stencils are complete and contain a node of the
 * grid: the inner nodes, and the places one step beyond joined sides. */
Range stencil_reach(Chart g, int axis);

/* The node at (i,j), which may lie up to two steps beyond joined sides; *sign is multiplied
 * by -1 where odd fields change their sign (chart.h). */
static inline size_t
stencil_node(Chart g, int i, int j, int *sign)
{
	if (i < 0 || i >= g.nu || j < 0 || j >= g.nv)
		*sign *= g.kind->beyond(g, &i, &j);
	return (size_t)j*g.nu + i;
}

/* ---- one node -------------------------------------------------------- */

/* The sum w[0] f[node[0]] + w[1] f[node[1]] + w[2] f[node[2]] for a field f.  The weights are
 * integers: the sum is to be divided by twice the step for a first derivative, by the square of the
 * step for a second. */
typedef struct Stencil {
	size_t node[3];
	double w[3];
} Stencil;

INLINE double
stencil_sum(const Stencil *s, const double *f)
{
	return s->w[0]*f[s->node[0]] + s->w[1]*f[s->node[1]] + s->w[2]*f[s->node[2]];
}

/* The stencil of a derivative of order 1 or 2 at node (i,j).  Order 1: the sum is 2h f_u (axis 0) or
 * 2k f_v (axis 1), at any node, central, or one-sided on an open side.  Order 2: the sum is h^2 f_uu
 * (axis 0) or k^2 f_vv (axis 1), at an inner node. */
Stencil stencil_at(Chart g, int axis, int order, int i, int j);

/* The same at a node whose neighbours are all in the grid (stencil_is_within). */
INLINE Stencil
stencil_within(Chart g, int axis, int order, int i, int j)
{
	size_t p = (size_t)j*g.nu + i, stride = axis ? (size_t)g.nu : 1;

	return order == 1 ? (Stencil){ { p + stride, p, p - stride }, { 1, 0, -1 } }
	    : (Stencil){ { p + stride, p, p - stride }, { 1, -2, 1 } };
}

INLINE int
stencil_is_within(Chart g, int i, int j)
{
	return i > 0 && i < g.nu - 1 && j > 0 && j < g.nv - 1;
}

INLINE void
stencil_sum3(const Stencil *s, const double *const phi[3], double divisor, double d[3])
{
	int c;

	for (c = 0; c < 3; c++)
		d[c] = stencil_sum(s, phi[c])/divisor;
}

/* phi_u and phi_v at any node; the error is of second order in h and k. */
INLINE void
stencil_tangents(Chart g, const double *const phi[3], int i, int j, double phi_u[3], double phi_v[3])
{
	double h2 = 2*chart_h(g), k2 = 2*chart_k(g);

	if (stencil_is_within(g, i, j)) {
		Stencil u = stencil_within(g, 0, 1, i, j), v = stencil_within(g, 1, 1, i, j);

		stencil_sum3(&u, phi, h2, phi_u);
		stencil_sum3(&v, phi, k2, phi_v);
	} else {
		Stencil u = stencil_at(g, 0, 1, i, j), v = stencil_at(g, 1, 1, i, j);

		stencil_sum3(&u, phi, h2, phi_u);
		stencil_sum3(&v, phi, k2, phi_v);
	}
}

/* phi_uu + phi_vv at an inner node.                                            (27) */
INLINE void
stencil_laplacian(Chart g, const double *const phi[3], int i, int j, double lap[3])
{
	double h = chart_h(g), k = chart_k(g);
	int within = stencil_is_within(g, i, j), c;
	Stencil uu = within ? stencil_within(g, 0, 2, i, j) : stencil_at(g, 0, 2, i, j);
	Stencil vv = within ? stencil_within(g, 1, 2, i, j) : stencil_at(g, 1, 2, i, j);

	for (c = 0; c < 3; c++)
		lap[c] = stencil_sum(&uu, phi[c])/(h*h) + stencil_sum(&vv, phi[c])/(k*k);
}

/* phi_uu, phi_uv and phi_vv at an inner node. */
void stencil_second_form(Chart g, const double *const phi[3], int i, int j, double uu[3], double uv[3],
	double vv[3]);

/* ---- four nodes at a time -------------------------------------------- */

enum { NODES = 4 };
typedef double Nodes __attribute__((vector_size(NODES*sizeof(double))));

/* Up to NODES nodes of a row: (i,j), (i+1,j), .., count of them.  If count < NODES, the remaining
 * lanes repeat the first node. */
typedef struct Quad {
	Chart  g;
	double per_h, per_k;    /* 1/h, 1/k */
	int    i, j, to, count; /* to: end of the range of nodes in row j */
	size_t p;               /* number of node (i,j) */
	int    inside;          /* count is NODES, and all neighbours are nodes of the grid */
} Quad;

/* Loads f at the `count` places (i,j), (i+1,j), .. into the lanes x; the other lanes repeat the first.
 * A place may lie beyond a joined side: the chart then defines the node that is read and, if f is
 * odd, the sign of f there. */
void quad_beside(Chart g, const double *f, int i, int j, int count, int odd, double x[NODES]);

INLINE void
quad_set(Quad *q)
{
	q->count = q->to - q->i < NODES ? q->to - q->i : NODES;
	q->inside = q->count == NODES && q->i > 0 && q->i + NODES < q->g.nu && q->j > 0 && q->j < q->g.nv - 1;
}

/* for (q = quad_row(g, r, j); q.count > 0; quad_next(&q)) visits the nodes i in r of row j. */
INLINE Quad
quad_row(Chart g, Range r, int j)
{
	Quad q = { .g = g, .per_h = chart_steps(g, 0), .per_k = chart_steps(g, 1)/g.T, .i = r.from, .j = j,
	    .to = r.to, .p = (size_t)j*g.nu + r.from };

	quad_set(&q);
	return q;
}

INLINE void
quad_next(Quad *q)
{
	q->i += NODES;
	q->p += NODES;
	quad_set(q);
}

INLINE void
quad_neighbours(const Quad *q, const double *f, int di, int dj, Nodes *x)
{
	double few[NODES];

	if (q->inside)
		f += q->p + di + (ptrdiff_t)dj*q->g.nu;
	else {
		quad_beside(q->g, f, q->i + di, q->j + dj, q->count, 0, few);
		f = few;
	}
	memcpy(x, f, sizeof *x);
}

/* Loads f at the places of q.  quad_load_odd is for odd fields: beyond a joined side the chart may
 * change their sign (chart.h). */
INLINE void
quad_load(const Quad *q, const double *f, Nodes *x)
{
	quad_neighbours(q, f, 0, 0, x);
}

INLINE void
quad_load_odd(const Quad *q, const double *f, Nodes *x)
{
	double few[NODES];

	if (q->inside)
		f += q->p;
	else {
		quad_beside(q->g, f, q->i, q->j, q->count, 1, few);
		f = few;
	}
	memcpy(x, f, sizeof *x);
}

/* f_u, f_v and Delta f of three fields, f[3][nv][nu], at places with complete stencils
 * (stencil_reach). */
INLINE void
quad_differences(const Quad *q, const double *f, Nodes u[3], Nodes v[3], Nodes L[3])
{
	size_t n = (size_t)q->g.nu*q->g.nv;
	double h = q->per_h, k = q->per_k;
	Nodes here, east, west, north, south;
	int c;

	for (c = 0; c < 3; c++, f += n) {
		quad_neighbours(q, f, 0, 0, &here);
		quad_neighbours(q, f, 1, 0, &east);
		quad_neighbours(q, f, -1, 0, &west);
		quad_neighbours(q, f, 0, 1, &north);
		quad_neighbours(q, f, 0, -1, &south);
		u[c] = (east - west)*(h/2);
		v[c] = (north - south)*(k/2);
		L[c] = (east - 2*here + west)*(h*h) + (north - 2*here + south)*(k*k);
	}
}

/* The transpose of quad_differences: row j of D_u'f_u + D_v'f_v + Delta'f_L, at the nodes i in r.
 *
 * u        in   f_u in row j, indices -1 .. nu; 0 outside the places of stencil_reach.  A place
 *               beyond a joined side has the value of the node that the chart defines for it, with
 *               the sign reversed if the directions of u and v are reversed there (chart.h)
 * v        in   f_v in rows j-1, j, j+1, likewise
 * L        in   f_L in these rows, likewise, but without change of sign
 * out      out  row j; nodes outside r are not changed */
INLINE void
stencil_transposed(Chart g, Range r, const double *u, const double *const v[3],
	const double *const L[3], double *out)
{
	double h = chart_steps(g, 0), k = chart_steps(g, 1)/g.T;        /* inverse steps */
	const double *below = v[0], *above = v[2], *L0 = L[0], *L1 = L[1], *L2 = L[2];
	int i;

	for (i = r.from; i < r.to; i++)
		out[i] = (u[i-1] - u[i+1])*(h/2) + (below[i] - above[i])*(k/2)
		    + (L1[i+1] - 2*L1[i] + L1[i-1])*(h*h) + (L2[i] - 2*L1[i] + L0[i])*(k*k);
}

#endif
