/* fitsolve.c - conjugate gradients for a Gauss-Newton step. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/cg.h"
#include "../base/field.h"
#include "fit.h"
#include "fitsolve.h"

static const double TENSION = 3;        /* of the plate, divided by w^2; 3 needs the fewest steps */
enum { MOST_CG = 60 };
/* With a free boundary surfaces bend easily and far.  CG gets few steps, as more
 * would be spent on bending that the next Gauss-Newton step undoes.  It gets many if the last step
 * was short, was not cut, and lowered E as predicted. */
enum { MOST_CG_FREE = 20, MOST_CG_NEAR = 400 };
static const double WORTH_NEAR = 1e-6;
static const double REDUCTION = 0.1;    /* of the preconditioned residual, in a Gauss-Newton step */
/* CG ends when one of its steps lowers E by less than WORTH times the decrease so far; with a held
 * boundary, by less than that plus WORTH_E E times the tolerance. */
static const double WORTH = 1e-3;
static const double WORTH_E = 0.1;
/* The first Gauss-Newton steps on a grid, which do not deflate the patch: deflation in the step from
 * the interpolated start can lead to another of several surfaces.  With residues, only the last
 * Gauss-Newton steps need many CG steps.  A step from the place is often the only one; cones that are held firm
 * are deflated in it, or spikes of H would be left beside them. */
enum { PLAIN = 1, PLAIN_EXACT = 4 };

static int
plain_steps(const Misfit *m)
{
	return m->residue ? PLAIN_EXACT : m->place && m->firm ? 0 : PLAIN;
}

void
fitsolve_free(FitSolve *k)
{
	plate_free(&k->plate);
	patch_free(&k->patch);
	free(k->r);
	free(k->z);
	free(k->p);
	free(k->q);
	free(k->d);
	free(k->y);
}

int
fitsolve_init(FitSolve *k, Misfit *m)
{
	*k = (FitSolve){ .m = m, .n = 3*(size_t)m->g.nu*m->g.nv, .radius = HUGE_VAL };
	k->r = malloc(k->n*sizeof(double));
	k->z = malloc(k->n*sizeof(double));
	k->p = malloc(k->n*sizeof(double));
	k->q = malloc(k->n*sizeof(double));
	k->d = malloc(k->n*sizeof(double));
	k->y = malloc(k->n*sizeof(double));
	if (!k->r || !k->z || !k->p || !k->q || !k->d || !k->y || plate_init(&k->plate, m->g, m->free)
	    || ((!m->free || m->firm) && patch_init(&k->patch, m))) {
		fitsolve_free(k);
		return FIT_ENOMEM;
	}
	return 0;
}

static void
apply_normal(void *work, const double *p, double *q)
{
	const FitSolve *k = work;

	misfit_normal(k->m, k->phi, p, q);
	if (k->deflate)
		patch_clear(&k->patch, q);
}

static void
precondition(void *work, const double *r, double *z)
{
	FitSolve *k = work;
	double w = k->m->w;

	field_scale(k->n, 1, r, z);
	plate_solve(&k->plate, k->m->scale, TENSION*w*w*k->m->scale, k->m->stiffness, z);
	k->solves++;
	if (k->deflate && patch_correct(&k->patch, z))
		k->error = FIT_ENOMEM;
}

/* Factors the matrix of the patch if this step deflates it.  A matrix that is not positive definite
 * is left to CG. */
static void
prepare_patch(FitSolve *k, const double *phi)
{
	int e = 0;

	k->deflate = k->patch.nodes && k->steps >= plain_steps(k->m);
	if (k->deflate)
		e = patch_set(&k->patch, phi);
	if (e)
		k->deflate = 0;
	if (e == PATCH_ENOMEM)
		k->error = FIT_ENOMEM;
}

/* Deflation: solves for d on the patch and updates r.  Returns the predicted decrease of E.  Its
 * square root is used as the length of d.  If that is the radius or more, d is cut to the radius and
 * *out is set. */
static double
solve_patch(FitSolve *k, const double *phi, int *out)
{
	double decrease = patch_start(&k->patch, k->r, k->d), t;

	*out = decrease >= k->radius*k->radius;
	if (isnan(decrease))
		k->error = FIT_ENOMEM;
	if (*out) {
		t = k->radius/sqrt(decrease);
		field_scale(k->n, t, k->d, k->d);
		return (2*t - t*t)*decrease;
	}
	misfit_normal(k->m, phi, k->d, k->q);
	field_add(k->n, -1, k->q, k->r);
	patch_clear(&k->patch, k->r);
	return decrease;
}

double
fitsolve(FitSolve *k, const double *phi, double E, double *length, int *spent)
{
	CgSystem s = { k->n, apply_normal, precondition, k };
	CgLimits limits = { REDUCTION, !k->m->free ? MOST_CG : k->near ? MOST_CG_NEAR : MOST_CG_FREE,
	    k->radius, k->m->free && k->near ? WORTH_NEAR : WORTH, 0 };
	double decrease = 0;
	int out = 0;
	CgResult is;

	k->phi = phi;
	*spent = 0;
	*length = k->radius;
	memset(k->d, 0, k->n*sizeof *k->d);
	prepare_patch(k, phi);
	if (k->deflate && !k->error)
		decrease = solve_patch(k, phi, &out);
	if (out || k->error)
		return decrease;
	limits.radius = sqrt(k->radius*k->radius - decrease);
	limits.before = decrease + (k->m->free ? 0 : WORTH_E*k->tolerance*E/WORTH);
	is = cg(&s, &limits, k->d, k->r, k->z, k->p, k->q);
	*spent = is.steps == limits.steps;
	*length = sqrt(is.length*is.length + decrease);
	return decrease + is.decrease;
}
