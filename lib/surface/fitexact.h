/* fitexact.h - the surface whose residual channels are known exactly.  doc/mathematics.md 6.7. */
#ifndef FITEXACT_H
#define FITEXACT_H

#include "fit.h"

/* lambda2, l2H  [nv][nu] lambda^2 and lambda^2 H of a surface on the grid g
 * r             the residues of the same surface; r->truncation is not read
 * o, phi, at    as for fit, the boundary held; o->exact is not read.  at->misfit <= FIT_EXACT if the
 *               surface is found; the solves are added to at->cost
 *
 * Returns as fit. */
int fitexact(Chart g, const double *lambda2, const double *l2H, const Residue *r, const FitOptions *o,
	double *phi, FitProgress *at);

#endif
