/* planelaplace.c - transforms by FFTW, divides by the eigenvalues of P, transforms back. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "planelaplace.h"

/* Whether fields are those of the doubled grid of a sock or a pillow. */
static int
is_folded(const PlaneLaplace *p)
{
	return p->g.kind->folded;
}

/* Whether the doubled grid is periodic along an axis. */
static int
is_periodic(const PlaneLaplace *p, int axis)
{
	return axis ? p->g.kind->closed : is_folded(p);
}

/* Steps along an axis: of the period, or between the sides. */
static int
cells(const PlaneLaplace *p, int axis)
{
	if (is_folded(p))
		return axis ? 2*p->g.nv - !p->g.kind->closed : p->g.nu;
	return (axis ? p->g.nv : p->g.nu) - 1;
}

/* The phase per step of wave k along an axis; in the half-complex order along a period. */
static double
phase(const PlaneLaplace *p, int axis, int k)
{
	int n = cells(p, axis);

	if (is_periodic(p, axis))
		return 2*M_PI*(k < n - k ? k : n - k)/n;
	return M_PI*(k + (axis == p->axis))/n;
}

static int
eigenvalues(PlaneLaplace *p, int axis, double step)
{
	int k;
	double t;

	p->stiff[axis] = malloc(p->n[axis]*sizeof(double));
	p->mass[axis] = malloc(p->n[axis]*sizeof(double));
	if (!p->stiff[axis] || !p->mass[axis])
		return PLANELAPLACE_ENOMEM;
	for (k = 0; k < p->n[axis]; k++) {
		t = phase(p, axis, k);
		p->stiff[axis][k] = (2 - 2*cos(t))/step;
		p->mass[axis][k] = (4 + 2*cos(t))*step/6;
	}
	return 0;
}

void
planelaplace_free(PlaneLaplace *p)
{
	int a;

	for (a = 0; a < 2; a++) {
		if (p->plan[a]) {
#pragma omp critical(planelaplace_plan)
			fftw_destroy_plan(p->plan[a]);
		}
		free(p->stiff[a]);
		free(p->mass[a]);
	}
	free(p->work);
}

static void
make_plans(PlaneLaplace *p)
{
	fftw_r2r_kind v = p->axis == 1 ? FFTW_RODFT00 : FFTW_REDFT00, u = p->axis == 0 ? FFTW_RODFT00 : FFTW_REDFT00;
	int k;

	for (k = 0; k < 2; k++) {
		if (is_periodic(p, 0))
			u = k ? FFTW_HC2R : FFTW_R2HC;
		if (is_periodic(p, 1))
			v = k ? FFTW_HC2R : FFTW_R2HC;
#pragma omp critical(planelaplace_plan)
		p->plan[k] = fftw_plan_r2r_2d(p->n[1], p->n[0], p->work, p->work, v, u, FFTW_ESTIMATE);
	}
}

int
planelaplace_init(PlaneLaplace *p, Chart g, int axis)
{
	size_t bytes;
	int e;

	*p = (PlaneLaplace){ .g = g, .axis = axis, .j0 = axis == 1 && !g.kind->closed };
	p->i0 = axis == 0 && !is_folded(p);
	p->n[0] = g.nu - 2*p->i0;
	p->n[1] = (is_folded(p) ? 2*g.nv : g.nv) - 2*p->j0;
	bytes = (size_t)p->n[0]*p->n[1]*sizeof(double);
	p->work = aligned_alloc(64, (bytes + 63)/64*64);
	e = p->work ? eigenvalues(p, 0, chart_h(g)) : PLANELAPLACE_ENOMEM;
	if (!e)
		e = eigenvalues(p, 1, chart_k(g));
	if (!e)
		make_plans(p);
	if (!e && !(p->plan[0] && p->plan[1]))
		e = PLANELAPLACE_ENOMEM;
	if (e)
		planelaplace_free(p);
	return e;
}

/* The right-hand side at node (i,j) of the workspace; on a doubled grid r is odd. */
static double
value_at(const PlaneLaplace *p, const double *r, int i, int j)
{
	int nu = p->g.nu, nv = p->g.nv;

	i += p->i0, j += p->j0;
	if (!is_folded(p))
		return r[(size_t)j*nu + i];
	return j < nv ? -r[(size_t)(nv - 1 - j)*nu + nu - 1 - i] : r[(size_t)(j - nv)*nu + i];
}

/* Let the columns of B be the eigenvectors.  They are orthogonal with the weights W, which are 1/2 at
 * free ends and 1 elsewhere.  Then P = W B Lambda B^-1, and z = B Lambda^-1 B' r up to a norm.  FFTW's
 * sine and cosine transforms double every term except those at free ends.  To undo this, r is divided
 * by 2 for each, and multiplied by 2 at free ends.  The constant, whose eigenvalue may be 0, is no odd
 * field. */
void
planelaplace_solve(const PlaneLaplace *p, const double *r, double *z)
{
	double norm = (double)cells(p, 0)*cells(p, 1), part, e;
	int i, j, nu = p->n[0], nv = p->n[1], fold = is_folded(p) ? p->g.nv : 0;
	size_t q;

	part = (is_periodic(p, 0) ? 1 : 0.5)*(is_periodic(p, 1) ? 1 : 0.5);
	for (q = 0, j = 0; j < nv; j++)
		for (i = 0; i < nu; i++, q++) {
			p->work[q] = value_at(p, r, i, j)*part;
			if (p->axis == 1 && !is_periodic(p, 0) && (i == 0 || i == nu - 1))
				p->work[q] *= 2;
			if (p->axis == 0 && !is_periodic(p, 1) && (j == 0 || j == nv - 1))
				p->work[q] *= 2;
		}
	fftw_execute(p->plan[0]);
	for (q = 0, j = 0; j < nv; j++)
		for (i = 0; i < nu; i++, q++) {
			e = p->stiff[0][i]*p->mass[1][j] + p->mass[0][i]*p->stiff[1][j];
			p->work[q] = e > 0 ? p->work[q]/(norm*e) : 0;
		}
	fftw_execute(p->plan[1]);
	memset(z, 0, (size_t)p->g.nu*p->g.nv*sizeof *z);
	for (q = 0, j = 0; j < nv; j++)
		for (i = 0; i < nu; i++, q++)
			if (j + p->j0 >= fold)
				z[(size_t)(j + p->j0 - fold)*p->g.nu + i + p->i0] = p->work[q];
}
