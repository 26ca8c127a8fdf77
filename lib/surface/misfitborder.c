/* misfitborder.c - the metric on a free boundary.
 *
 * The border is thin: one node at a time, in a fixed order. */
#include <math.h>

#include "../grid/border.h"
#include "misfitborder.h"
#include "../base/vec3.h"

/* Of w: what is told of lambda on the border is continued from within (lambdah.h), and one-sided
 * differences are off by more.  At 0.3 and 1 kinks of the outermost cells hold the steps up. */
static const double SHARE = 0.1;

/* f' = sum w f[at], in one direction. */
typedef struct Stencil {
	ptrdiff_t at[3];
	double    w[3];
} Stencil;

typedef struct Metric {
	double r[3], w[3];      /* scale, the two of shape; by what their squares are multiplied */
} Metric;

static Stencil
stencil(int i, int n, ptrdiff_t stride, double step)
{
	double w = 0.5/step;

	if (i == 0)
		return (Stencil){ { 0, stride, 2*stride }, { -3*w, 4*w, -w } };
	if (i == n - 1)
		return (Stencil){ { 0, -stride, -2*stride }, { 3*w, -4*w, w } };
	return (Stencil){ { -stride, 0, stride }, { -w, 0, w } };
}

static void
stencils(Chart g, size_t p, Stencil *u, Stencil *v)
{
	*u = stencil((int)(p%g.nu), g.nu, 1, chart_h(g));
	*v = stencil((int)(p/g.nu), g.nv, g.nu, chart_k(g));
}

static double
slope(const Stencil *s, const double *f)
{
	return s->w[0]*f[s->at[0]] + s->w[1]*f[s->at[1]] + s->w[2]*f[s->at[2]];
}

static double
log_slope(const Stencil *s, const double *f)
{
	return s->w[0]*log(f[s->at[0]]) + s->w[1]*log(f[s->at[1]]) + s->w[2]*log(f[s->at[2]]);
}

static void
slopes(const Stencil *s, const double *f, size_t n, double x[3])
{
	int c;

	for (c = 0; c < 3; c++)
		x[c] = slope(s, f + c*n);
}

static int
border_count(Chart g)
{
	return 2*(g.nu - 1) + 2*(g.nv - 1);
}

static size_t
node(Chart g, int k)
{
	int i, j;

	border_node(g.nu, g.nv, k, &i, &j);
	return (size_t)j*g.nu + i;
}

void
misfit_border_weights(Misfit *m)
{
	Stencil u, v;
	double x, y;
	size_t p;
	int q;

	for (q = 0; q < border_count(m->g); q++) {
		p = node(m->g, q);
		stencils(m->g, p, &u, &v);
		x = log_slope(&u, m->lambda2 + p)/2;
		y = log_slope(&v, m->lambda2 + p)/2;
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

	for (*most = -1, *worst = 0, q = 0; q < border_count(m->g); q++) {
		p = node(m->g, q);
		stencils(m->g, p, &su, &sv);
		slopes(&su, phi + p, n, u);
		slopes(&sv, phi + p, n, v);
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
			g[c*n + s->at[k]] += s->w[k]*x[c];
}

void
misfit_border_apply(const Misfit *m, const double *phi, const double *d, double *g)
{
	size_t n = (size_t)m->g.nu*m->g.nv, p;
	double u[3], v[3], du[3], dv[3], to_u[3], to_v[3];
	Stencil su, sv;
	Metric a;
	int q, c;

	for (q = 0; q < border_count(m->g); q++) {
		p = node(m->g, q);
		stencils(m->g, p, &su, &sv);
		slopes(&su, phi + p, n, u);
		slopes(&sv, phi + p, n, v);
		metric(m, p, u, v, &a);
		if (d) {
			slopes(&su, d + p, n, du);
			slopes(&sv, d + p, n, dv);
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
		scatter(&su, to_u, n, g + p);
		scatter(&sv, to_v, n, g + p);
	}
}
