/* misfitborder.c - the energy of the metric on a free boundary.
 *
 * The border has few nodes, so they are done one at a time, in a fixed order. */
#include <math.h>

#include "../grid/border.h"
#include "../grid/stencil.h"
#include "misfitborder.h"
#include "../base/vec3.h"

/* Factor of w on the border, where lambda is only extrapolated from inside (lambdah.h) and
 * one-sided differences have larger errors.  With 0.3 and with 1, kinks in the outermost cells slow
 * the steps down. */
static const double SHARE = 0.1;

typedef struct Metric {
	double r[3], w[3];      /* residuals of scale and (two) of shape; weights of their squares */
} Metric;

/* The difference stencils of phi_u and phi_v at node (i,j). */
static void
slopes_at(Chart g, int i, int j, Stencil *u, Stencil *v)
{
	int k;

	*u = stencil_at(g, 0, 1, i, j);
	*v = stencil_at(g, 1, 1, i, j);
	for (k = 0; k < 3; k++) {
		u->w[k] *= 0.5/chart_h(g);
		v->w[k] *= 0.5/chart_k(g);
	}
}

/* A derivative of log(lambda/lambda0)^2. */
static double
log_slope(const Misfit *m, const Stencil *s)
{
	return s->w[0]*log(misfit_size2(m, s->node[0])) + s->w[1]*log(misfit_size2(m, s->node[1]))
	    + s->w[2]*log(misfit_size2(m, s->node[2]));
}

static void
slopes(const Stencil *s, const double *f, size_t n, double x[3])
{
	int c;

	for (c = 0; c < 3; c++)
		x[c] = stencil_sum(s, f + c*n);
}

/* Number of grid steps round the edge of the grid. */
static int
edge_length(Chart g)
{
	return 2*(g.nu - 1) + 2*(g.nv - 1);
}

/* Sets *p to node k of the edge, and u and v to its difference stencils.  Returns whether the node
 * lies on an open side. */
static int
border_slopes(Chart g, int k, size_t *p, Stencil *u, Stencil *v)
{
	int i, j;

	border_node(g.nu, g.nv, k, &i, &j);
	*p = (size_t)j*g.nu + i;
	slopes_at(g, i, j, u, v);
	return !stencil_is_inner(g, i, j);
}

void
misfit_border_weights(Misfit *m)
{
	Stencil u, v;
	double x, y;
	size_t p;
	int q;

	for (q = 0; q < edge_length(m->g); q++) {
		if (!border_slopes(m->g, q, &p, &u, &v))
			continue;
		x = log_slope(m, &u)/2;
		y = log_slope(m, &v)/2;
		m->o[p] = misfit_weight(m, p, x*x + y*y);
	}
}

static void
metric(const Misfit *m, size_t p, const double u[3], const double v[3], Metric *a)
{
	double E = dot3(u, u), F = dot3(u, v), G = dot3(v, v), l2 = m->lambda2[p];

	a->r[0] = (E + G)/2 - l2;
	a->r[1] = (E - G)/2;
	a->r[2] = F;
	a->w[0] = SHARE*SHARE*m->w*m->w*m->scale/l2*m->o[p];
	a->w[1] = a->w[2] = a->w[0]*m->o[p];
}

double
misfit_border_energy(const Misfit *m, const double *phi, size_t *worst, double *most)
{
	size_t n = (size_t)m->g.nu*m->g.nv, p;
	double sum = 0, u[3], v[3], e;
	Stencil su, sv;
	Metric a;
	int q;

	for (*most = -1, *worst = 0, q = 0; q < edge_length(m->g); q++) {
		if (!border_slopes(m->g, q, &p, &su, &sv))
			continue;
		slopes(&su, phi, n, u);
		slopes(&sv, phi, n, v);
		metric(m, p, u, v, &a);
		e = a.w[0]*a.r[0]*a.r[0] + a.w[1]*(a.r[1]*a.r[1] + a.r[2]*a.r[2]);
		sum += e;
		if (!(e <= *most)) {
			*most = e;
			*worst = p;
		}
	}
	return sum;
}

static void
scatter(const Stencil *s, const double x[3], size_t n, double *g)
{
	int c, k;

	for (c = 0; c < 3; c++)
		for (k = 0; k < 3; k++)
			g[c*n + s->node[k]] += s->w[k]*x[c];
}

void
misfit_border_apply(const Misfit *m, const double *phi, const double *d, double *g)
{
	size_t n = (size_t)m->g.nu*m->g.nv, p;
	double u[3], v[3], du[3], dv[3], to_u[3], to_v[3];
	Stencil su, sv;
	Metric a;
	int q, c;

	for (q = 0; q < edge_length(m->g); q++) {
		if (!border_slopes(m->g, q, &p, &su, &sv))
			continue;
		slopes(&su, phi, n, u);
		slopes(&sv, phi, n, v);
		metric(m, p, u, v, &a);
		if (d) {
			slopes(&su, d, n, du);
			slopes(&sv, d, n, dv);
			a.r[0] = dot3(u, du) + dot3(v, dv);
			a.r[1] = dot3(u, du) - dot3(v, dv);
			a.r[2] = dot3(u, dv) + dot3(v, du);
		}
		for (c = 0; c < 3; c++)
			a.r[c] *= a.w[c];
		for (c = 0; c < 3; c++) {
			to_u[c] = (a.r[0] + a.r[1])*u[c] + a.r[2]*v[c];
			to_v[c] = (a.r[0] - a.r[1])*v[c] + a.r[2]*u[c];
		}
		scatter(&su, to_u, n, g);
		scatter(&sv, to_v, n, g);
	}
}
