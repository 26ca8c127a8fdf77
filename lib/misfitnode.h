/* misfitnode.h - the residuals of one node and their derivatives.  Private to misfit. */
#ifndef MISFITNODE_H
#define MISFITNODE_H

#include "misfit.h"
#include "vec3.h"

enum { MISFIT_PARTS = 6 };      /* residuals of a node: normal, along phi_u and phi_v, scale,
                                 * the two of shape */

/* Strips of 32 rows, the last ones of fewer: what a thread takes at a time. */
static inline int
misfit_strips(Chart g)
{
	return (g.nv - 2 + 31)/32;
}

/* What the differences of the surface are at a node. */
typedef struct Local {
	double u[3], v[3];      /* phi_u, phi_v */
	double L[3];            /* Delta phi */
	double n[3], area;      /* normal, phi_u x phi_v over the area of the node */
} Local;

/* Weights of the six residuals of a node. */
typedef struct Weights {
	double normal, along, scale, shape;
} Weights;

static inline void
differences(Chart g, const double *f, size_t p, double u[3], double v[3], double L[3])
{
	size_t n = (size_t)g.nu*g.nv, up = g.nu;
	double h = g.nu - 1, k = (g.nv - 1)/g.T;        /* their inverses */
	int c;

	for (c = 0; c < 3; c++, f += n) {
		u[c] = (f[p+1] - f[p-1])*(h/2);
		v[c] = (f[p+up] - f[p-up])*(k/2);
		L[c] = (f[p+1] - 2*f[p] + f[p-1])*(h*h) + (f[p+up] - 2*f[p] + f[p-up])*(k*k);
	}
}

static inline void
local(const Misfit *m, const double *phi, size_t p, Local *a)
{
	int c;

	differences(m->g, phi, p, a->u, a->v, a->L);
	cross3(a->u, a->v, a->n);
	a->area = sqrt(dot3(a->n, a->n) + m->blur*m->lambda2[p]*m->lambda2[p]) + 1e-300;
	for (c = 0; c < 3; c++)
		a->n[c] /= a->area;
}

static inline Weights
weights(const Misfit *m, size_t p)
{
	double root = sqrt(m->scale), metric = root/sqrt(m->lambda2[p]), o = m->o[p];

	return (Weights){ o*root, m->alpha*o*metric, m->w*sqrt(o)*metric, m->w*o*metric };
}

static inline void
residuals(const Misfit *m, const Local *a, size_t p, double r[MISFIT_PARTS])
{
	double E = dot3(a->u, a->u), F = dot3(a->u, a->v), G = dot3(a->v, a->v);
	const Residue *e = m->residue;
	double l2 = m->lambda2[p];
	Weights w = weights(m, p);

	r[0] = w.normal*(dot3(a->L, a->n) - m->l2H2[p]);
	r[1] = w.along*(dot3(a->L, a->u) - (e ? e->tau[0][p]*l2 : 0));
	r[2] = w.along*(dot3(a->L, a->v) - (e ? e->tau[1][p]*l2 : 0));
	r[3] = w.scale*((E + G)/2 - l2);
	r[4] = w.shape*((E - G)/2 - (e ? e->nu[0][p]*l2 : 0));
	r[5] = w.shape*(F - (e ? e->nu[1][p]*l2 : 0));
}

/* dr for a displacement d.  With c = phi_u x phi_v:  dn = (dc - <dc, n> n)/|c|. */
static inline void
change(const Misfit *m, const Local *a, const double *d, size_t p, double r[MISFIT_PARTS])
{
	double du[3], dv[3], dL[3], x[3], y[3], across[3], along = dot3(a->L, a->n);
	Weights w = weights(m, p);
	int c;

	differences(m->g, d, p, du, dv, dL);
	cross3(du, a->v, x);
	cross3(a->u, dv, y);
	for (c = 0; c < 3; c++) {
		x[c] += y[c];
		across[c] = a->L[c] - along*a->n[c];
	}
	r[0] = w.normal*(dot3(dL, a->n) + dot3(across, x)/a->area);
	r[1] = w.along*(dot3(dL, a->u) + dot3(a->L, du));
	r[2] = w.along*(dot3(dL, a->v) + dot3(a->L, dv));
	r[3] = w.scale*(dot3(a->u, du) + dot3(a->v, dv));
	r[4] = w.shape*(dot3(a->u, du) - dot3(a->v, dv));
	r[5] = w.shape*(dot3(a->v, du) + dot3(a->u, dv));
}

/* The adjoint of change: what <r, dr> says of du, dv and dL, three numbers each. */
static inline void
spread(const Misfit *m, const Local *a, size_t p, const double r[MISFIT_PARTS], double f[9])
{
	Weights w = weights(m, p);
	double normal = w.normal*r[0], t1 = w.along*r[1], t2 = w.along*r[2];
	double uu = w.scale*r[3] + w.shape*r[4], vv = w.scale*r[3] - w.shape*r[4], uv = w.shape*r[5];
	double x[3], y[3], across[3], along = dot3(a->L, a->n);
	int c;

	for (c = 0; c < 3; c++)
		across[c] = (a->L[c] - along*a->n[c])*(normal/a->area);
	cross3(a->v, across, x);
	cross3(across, a->u, y);
	for (c = 0; c < 3; c++) {
		f[c] = uu*a->u[c] + uv*a->v[c] + t1*a->L[c] + x[c];
		f[3+c] = vv*a->v[c] + uv*a->u[c] + t2*a->L[c] + y[c];
		f[6+c] = normal*a->n[c] + t1*a->u[c] + t2*a->v[c];
	}
}

#endif
