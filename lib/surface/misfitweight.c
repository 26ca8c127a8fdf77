/* misfitweight.c - the weight of a node in the energy. */
#include "misfitborder.h"

static const double LEAST = 1e-4;       /* (lambda/lambda0)^2/<lambda^2> below which o is lowered (misfit.h) */

double
misfit_step2(Chart g)
{
	double h = chart_h(g), k = chart_k(g);

	return (h*h + k*k)/2;
}

double
misfit_size2(const Misfit *m, size_t p)
{
	return m->round ? m->lambda2[p]/m->round[p] : m->lambda2[p];
}

double
misfit_weight(const Misfit *m, size_t p, double gradient2)
{
	double l2 = m->lambda2[p], l2H = m->l2H2[p]/2;
	double q2 = misfit_step2(m->g)*(l2H*l2H/l2 + 4*gradient2), relative = misfit_size2(m, p)*m->scale/m->g.T;

	if (m->residue)
		q2 *= m->residue->truncation;
	if (relative < LEAST)
		return m->residue ? relative/LEAST/(1 + 4*q2) : 0;
	return 1/(1 + 4*q2);
}
