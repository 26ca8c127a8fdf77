/* misfitnode.h - the residuals of a node and their derivatives.  Private to misfit.
 *
 * Four neighbouring nodes of a row are computed at a time, in vectors.  For a processor with
 * shorter vectors the compiler splits them; the results are the same. */
#ifndef MISFITNODE_H
#define MISFITNODE_H

#include <math.h>

#include "../grid/stencil.h"
#include "misfit.h"

enum { MISFIT_PARTS = 6 };      /* residuals of a node: normal, along phi_u and phi_v, scale,
                                 * the two of shape */

#define DOT(a, b) ((a)[0]*(b)[0] + (a)[1]*(b)[1] + (a)[2]*(b)[2])

/* Number of strips of at most 32 rows; a thread does one at a time. */
static inline int
misfit_strips(Chart g)
{
	Range rows = stencil_inner(g, 1);

	return (rows.to - rows.from + 31)/32;
}

/* The differences of the surface at four nodes. */
typedef struct Local {
	Nodes u[3], v[3];       /* phi_u, phi_v */
	Nodes L[3];             /* Delta phi */
	Nodes n[3], area;       /* normal and area element, misfit.h */
	Nodes along;            /* <Delta phi, n>; 0 where the area element is known */
} Local;

INLINE void
cross_nodes(const Nodes a[3], const Nodes b[3], Nodes c[3])
{
	c[0] = a[1]*b[2] - a[2]*b[1];
	c[1] = a[2]*b[0] - a[0]*b[2];
	c[2] = a[0]*b[1] - a[1]*b[0];
}

/* (|phi_u x phi_v|/lambda^2)^2 of the surface that the residue comes from, at least 1e-12. */
INLINE void
known_area2(const Residue *r, const Quad *q, Nodes *a)
{
	Nodes x, y;
	int c;

	quad_load(q, r->nu[0], &x);
	quad_load(q, r->nu[1], &y);
	*a = 1 - x*x - y*y;
	for (c = 0; c < NODES; c++)
		(*a)[c] = (*a)[c] > 1e-12 ? (*a)[c] : 1e-12;
}

INLINE void
local(const Misfit *m, const double *phi, const Quad *q, Local *a)
{
	Nodes l2;
	int c;

	quad_differences(q, phi, a->u, a->v, a->L);
	cross_nodes(a->u, a->v, a->n);
	quad_load(q, m->lambda2, &l2);
	if (m->residue) {
		known_area2(m->residue, q, &a->area);
		a->area *= l2*l2;
	} else
		a->area = DOT(a->n, a->n) + m->blur*l2*l2;
	for (c = 0; c < NODES; c++)
		a->area[c] = sqrt(a->area[c]) + 1e-300;
	for (c = 0; c < 3; c++)
		a->n[c] /= a->area;
	a->along = DOT(a->L, a->n);
	if (m->residue)
		a->along *= 0;
}

/* The weights of the squared residuals. */
INLINE void
weights(const Misfit *m, const Quad *q, Nodes w[MISFIT_PARTS])
{
	Nodes o, l2, metric, area2, firm;

	quad_load(q, m->o, &o);
	quad_load(q, m->lambda2, &l2);
	metric = m->scale/l2*o;
	w[0] = m->scale*o*o;
	if (m->residue) {
		known_area2(m->residue, q, &area2);
		w[0] *= area2;
	}
	w[1] = w[2] = m->alpha*m->alpha*metric*o;
	if (m->firm) {
		quad_load(q, m->firm, &firm);
		w[0] *= firm;
		w[1] *= firm;
		w[2] = w[1];
	}
	w[3] = m->w*m->w*metric*m->stretch;
	w[4] = w[5] = m->w*m->w*metric*o;
}

INLINE void
residuals(const Misfit *m, const Local *a, const Quad *q, Nodes r[MISFIT_PARTS])
{
	Nodes E = DOT(a->u, a->u), F = DOT(a->u, a->v), G = DOT(a->v, a->v), l2, l2H2, e;
	int i;

	quad_load(q, m->lambda2, &l2);
	quad_load(q, m->l2H2, &l2H2);
	r[0] = DOT(a->L, a->n) - l2H2;
	r[1] = DOT(a->L, a->u);
	r[2] = DOT(a->L, a->v);
	r[3] = (E + G)/2 - l2;
	r[4] = (E - G)/2;
	r[5] = F;
	for (i = 0; m->residue && i < 2; i++) {
		quad_load_odd(q, m->residue->tau[i], &e);
		r[1+i] -= e*l2;
		quad_load(q, m->residue->nu[i], &e);
		r[4+i] -= e*l2;
	}
}

/* dr for a displacement d.  With c = phi_u x phi_v and n = c/area:  dn = (dc - <dc, n> n)/area, or
 * dn = dc/area where the area element is known, so that it does not change with d. */
INLINE void
change(const Local *a, const double *d, const Quad *q, Nodes r[MISFIT_PARTS])
{
	Nodes du[3], dv[3], dL[3], x[3], y[3], across[3];
	int c;

	quad_differences(q, d, du, dv, dL);
	cross_nodes(du, a->v, x);
	cross_nodes(a->u, dv, y);
	for (c = 0; c < 3; c++) {
		x[c] += y[c];
		across[c] = a->L[c] - a->along*a->n[c];
	}
	r[0] = DOT(dL, a->n) + DOT(across, x)/a->area;
	r[1] = DOT(dL, a->u) + DOT(a->L, du);
	r[2] = DOT(dL, a->v) + DOT(a->L, dv);
	r[3] = DOT(a->u, du) + DOT(a->v, dv);
	r[4] = DOT(a->u, du) - DOT(a->v, dv);
	r[5] = DOT(a->v, du) + DOT(a->u, dv);
}

/* The adjoint of change: the gradient of <r, dr> with respect to du, dv and dL, three numbers
 * each. */
INLINE void
change_adjoint(const Local *a, const Nodes r[MISFIT_PARTS], Nodes f[9])
{
	Nodes uu = r[3] + r[4], vv = r[3] - r[4];
	Nodes x[3], y[3], across[3], normal = r[0]/a->area;
	int c;

	for (c = 0; c < 3; c++)
		across[c] = (a->L[c] - a->along*a->n[c])*normal;
	cross_nodes(a->v, across, x);
	cross_nodes(across, a->u, y);
	for (c = 0; c < 3; c++) {
		f[c] = uu*a->u[c] + r[5]*a->v[c] + r[1]*a->L[c] + x[c];
		f[3+c] = vv*a->v[c] + r[5]*a->u[c] + r[2]*a->L[c] + y[c];
		f[6+c] = r[0]*a->n[c] + r[1]*a->u[c] + r[2]*a->v[c];
	}
}

#endif
