/* fitexact.c - fits with several sets of weights, until one finds the surface where E is 0. */
#include <stdlib.h>
#include <string.h>

#include "fitexact.h"

/* There is no truncation to allow for, so w is sharp; with alpha = 1 the operator is near the plate of
 * the preconditioner.  The surface has E = 0 with both sets of weights.  One set may lead to another
 * minimum, mostly with the normal turned over at one node, where the other set does not. */
static const struct Way {
	FitWeights weights;
	double     truncation;  /* misfit.h */
} WAYS[] = { { { 200, 1 }, 0.3 }, { { 100, 0.1 }, 1 } };
enum { COUNT = sizeof WAYS/sizeof *WAYS, FEW = 40 };    /* FEW: most steps, except with the last set */

static int
one_way(const struct Way *way, Chart g, const double *lambda2, const double *l2H, const Residue *r,
	FitOptions o, double *phi, FitProgress *at)
{
	Residue residue = *r;
	Misfit m;
	int e;

	residue.truncation = way->truncation;
	o.exact = &way->weights;
	if (misfit_init(&m, g, lambda2, l2H, &residue))
		return FIT_ENOMEM;
	e = fit(&m, &o, phi, at);
	at->cost += at->solves;
	misfit_free(&m);
	return e;
}

int
fitexact(Chart g, const double *lambda2, const double *l2H, const Residue *r, const FitOptions *o,
	double *phi, FitProgress *at)
{
	size_t n = 3*(size_t)g.nu*g.nv;
	double *start = malloc(n*sizeof *start);
	FitOptions few = *o;
	int e = start ? 0 : FIT_ENOMEM, k;

	if (start)
		memcpy(start, phi, n*sizeof *start);
	few.most = o->most < FEW ? o->most : FEW;
	for (k = 0; e >= 0 && k < COUNT && !(e && at->misfit <= FIT_EXACT); k++) {
		memcpy(phi, start, n*sizeof *start);
		e = one_way(&WAYS[k], g, lambda2, l2H, r, k < COUNT - 1 ? few : *o, phi, at);
	}
	free(start);
	return e;
}
