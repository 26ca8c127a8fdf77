/* blendmetric.c - lambda, H, nu and tau between several surfaces, node by node. */
#include <math.h>

#include "../grid/stencil.h"
#include "blend.h"
#include "blendmetric.h"

/* |nu| is 1 where phi_u and phi_v are parallel; the logarithm of such a metric is infinite. */
static const double DEGENERATE = 0.9999;

/* The logarithm of a metric at a node. */
typedef struct LogMetric {
	double m, p, q;
} LogMetric;

static LogMetric
log_metric(double lambda, double nu1, double nu2)
{
	double r = fmin(hypot(nu1, nu2), DEGENERATE), f = r > 0 ? atanh(r)/hypot(nu1, nu2) : 0;

	return (LogMetric){ 2*log(lambda) + log1p(-r*r)/2, f*nu1, f*nu2 };
}

static void
exp_metric(LogMetric l, double *lambda, double *nu1, double *nu2)
{
	double s = hypot(l.p, l.q), f = s > 0 ? tanh(s)/s : 0;

	*lambda = exp(l.m/2)*sqrt(cosh(s));
	*nu1 = f*l.p;
	*nu2 = f*l.q;
}

/* log lambda and lambda^2 H are linear. */
static void
conformal_node(int count, const double *w, const Metric *of, const Metric *to, size_t p)
{
	double l = 0, c = 0;
	int k;

	for (k = 0; k < count; k++) {
		double lambda = of[k].lambda[p];

		l += w[k]*log(lambda);
		c += w[k]*(lambda*lambda*of[k].H[p]);
	}
	to->lambda[p] = exp(l);
	to->H[p] = c/(to->lambda[p]*to->lambda[p]);
}

/* log g and lambda H are linear. */
static void
metric_node(int count, const double *w, const Metric *of, const Metric *to, size_t p)
{
	LogMetric sum = { 0, 0, 0 };
	double c = 0;
	int k;

	for (k = 0; k < count; k++) {
		LogMetric l = log_metric(of[k].lambda[p], of[k].nu[0][p], of[k].nu[1][p]);

		sum.m += w[k]*l.m;
		sum.p += w[k]*l.p;
		sum.q += w[k]*l.q;
		c += w[k]*(of[k].lambda[p]*of[k].H[p]);
	}
	exp_metric(sum, &to->lambda[p], &to->nu[0][p], &to->nu[1][p]);
	to->H[p] = c/to->lambda[p];
}

/* The stencil of a first derivative at inner node (i,j), 2h or 2k times, from inner nodes alone: nu is 0 on
 * open sides, whatever the surface is there. */
static Stencil
inner_difference(Chart g, int axis, int i, int j)
{
	Range r = stencil_inner(g, axis);
	int n = axis ? g.nv : g.nu, at = axis ? j : i, k, d;
	Stencil s = { { 0, 0, 0 }, { 0, 0, 0 } };

	d = r.from > 0 && at == r.from ? 1 : r.to < n && at == r.to - 1 ? -1 : 0;
	if (!d)
		return stencil_at(g, axis, 1, i, j);
	for (k = 0; k < 3 && r.to - r.from >= 3; k++) {
		static const double w[3] = { -3, 4, -1 };

		s.node[k] = (size_t)(axis ? j + k*d : j)*g.nu + (axis ? i : i + k*d);
		s.w[k] = d*w[k];
	}
	return s;
}

/* lambda^2 nu[c] summed over a stencil. */
static double
sum_nu(const Metric *m, const Stencil *s, int c)
{
	double sum = 0;
	int k;

	for (k = 0; k < 3; k++)
		sum += s->w[k]*m->lambda[s->node[k]]*m->lambda[s->node[k]]*m->nu[c][s->node[k]];
	return sum;
}

void
blendmetric_tau(const Metric *m, int i, int j, double tau[2])
{
	Stencil u = inner_difference(m->g, 0, i, j), v = inner_difference(m->g, 1, i, j);
	double lambda = m->lambda[(size_t)j*m->g.nu + i], l2 = lambda*lambda;
	double h2 = 2*chart_h(m->g)*l2, k2 = 2*chart_k(m->g)*l2;

	tau[0] = sum_nu(m, &u, 0)/h2 + sum_nu(m, &v, 1)/k2;
	tau[1] = sum_nu(m, &u, 1)/h2 - sum_nu(m, &v, 0)/k2;
}

/* tau at node (i,j), after lambda and nu at all nodes. */
static void
tau_node(int count, const double *w, const Metric *of, const Metric *to, int i, int j)
{
	size_t p = (size_t)j*to->g.nu + i;
	double tau[2];
	int k, c;

	to->tau[0][p] = to->tau[1][p] = 0;
	if (!stencil_is_inner(to->g, i, j))
		return;
	blendmetric_tau(to, i, j, tau);
	for (c = 0; c < 2; c++)
		to->tau[c][p] = tau[c];
	for (k = 0; k < count; k++) {
		blendmetric_tau(&of[k], i, j, tau);
		for (c = 0; c < 2; c++)
			to->tau[c][p] += w[k]*(of[k].tau[c][p] - tau[c]);
	}
}

static void
copy(const Metric *from, const Metric *to)
{
	size_t bytes = (size_t)to->g.nu*to->g.nv*sizeof *to->lambda;
	int c;

	memcpy(to->lambda, from->lambda, bytes);
	memcpy(to->H, from->H, bytes);
	for (c = 0; c < 2 && to->nu[0]; c++) {
		memcpy(to->nu[c], from->nu[c], bytes);
		memcpy(to->tau[c], from->tau[c], bytes);
	}
}

void
blendmetric(int count, const double *w, const Metric *of, const double *e, const Metric *to)
{
	int single = blend_single(count, w), i, j;
	size_t n = (size_t)to->g.nu*to->g.nv, p;

	if (single >= 0) {
		copy(&of[single], to);
		return;
	}
#pragma omp parallel for schedule(static)
	for (p = 0; p < n; p++) {
		if (to->nu[0])
			metric_node(count, w, of, to, p);
		else
			conformal_node(count, w, of, to, p);
		if (e) {
			to->lambda[p] *= exp(e[p]);
			to->H[p] /= exp(e[p]);
		}
	}
	if (!to->nu[0])
		return;
#pragma omp parallel for schedule(static) private(i)
	for (j = 0; j < to->g.nv; j++)
		for (i = 0; i < to->g.nu; i++)
			tau_node(count, w, of, to, i, j);
}
