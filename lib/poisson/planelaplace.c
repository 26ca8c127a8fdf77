/* planelaplace.c - transforms by FFTW, divides by the eigenvalues of P, transforms back. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "planelaplace.h"

static int
eigenvalues(PlaneLaplace *p, int axis, double step, int cells)
{
	int k, sines = axis == p->axis;
	double t;

	p->stiff[axis] = malloc(p->n[axis]*sizeof(double));
	p->mass[axis] = malloc(p->n[axis]*sizeof(double));
	if (!p->stiff[axis] || !p->mass[axis])
		return PLANELAPLACE_ENOMEM;
	for (k = 0; k < p->n[axis]; k++) {
		t = M_PI*(k + sines)/cells;
		p->stiff[axis][k] = (2 - 2*cos(t))/step;
		p->mass[axis][k] = (4 + 2*cos(t))*step/6;
	}
	return 0;
}

void
planelaplace_free(PlaneLaplace *p)
{
	int a;

	if (p->plan) {
#pragma omp critical(planelaplace_plan)
		fftw_destroy_plan(p->plan);
	}
	free(p->work);
	for (a = 0; a < 2; a++) {
		free(p->stiff[a]);
		free(p->mass[a]);
	}
}

int
planelaplace_init(PlaneLaplace *p, Chart g, int axis)
{
	size_t bytes;
	int e;

	*p = (PlaneLaplace){ .g = g, .axis = axis, .i0 = axis == 0, .j0 = axis == 1 };
	p->n[0] = g.nu - 2*p->i0;
	p->n[1] = g.nv - 2*p->j0;
	bytes = (size_t)p->n[0]*p->n[1]*sizeof(double);
	p->work = aligned_alloc(64, (bytes + 63)/64*64);
	e = p->work ? eigenvalues(p, 0, chart_h(g), g.nu - 1) : PLANELAPLACE_ENOMEM;
	if (!e)
		e = eigenvalues(p, 1, chart_k(g), g.nv - 1);
	if (!e) {
#pragma omp critical(planelaplace_plan)
		p->plan = fftw_plan_r2r_2d(p->n[1], p->n[0], p->work, p->work,
		    axis == 1 ? FFTW_RODFT00 : FFTW_REDFT00,
		    axis == 0 ? FFTW_RODFT00 : FFTW_REDFT00, FFTW_ESTIMATE);
	}
	if (!e && !p->plan)
		e = PLANELAPLACE_ENOMEM;
	if (e)
		planelaplace_free(p);
	return e;
}

/* Let the columns of B be the eigenvectors, products of sines and cosines.  They are orthogonal
 * with the weights W, which are 1/2 at free ends and 1 elsewhere.  Then P = W B Lambda B^-1, and z
 * = B Lambda^-1 B' r up to a norm.  FFTW's transforms double every term except those at free ends.
 * To undo this, r is divided by 4, and multiplied by 2 at free ends. */
void
planelaplace_solve(const PlaneLaplace *p, const double *r, double *z)
{
	double norm = (p->g.nu - 1.0)*(p->g.nv - 1.0);
	int i, j, nu = p->n[0], nv = p->n[1];
	size_t q, node;

	for (q = 0, j = 0; j < nv; j++)
		for (i = 0; i < nu; i++, q++) {
			node = (size_t)(j + p->j0)*p->g.nu + i + p->i0;
			p->work[q] = r[node]/4;
			if (p->axis == 1 && (i == 0 || i == nu - 1))
				p->work[q] *= 2;
			if (p->axis == 0 && (j == 0 || j == nv - 1))
				p->work[q] *= 2;
		}
	fftw_execute(p->plan);
	for (q = 0, j = 0; j < nv; j++)
		for (i = 0; i < nu; i++, q++)
			p->work[q] /= norm*(p->stiff[0][i]*p->mass[1][j] + p->mass[0][i]*p->stiff[1][j]);
	fftw_execute(p->plan);
	memset(z, 0, (size_t)p->g.nu*p->g.nv*sizeof *z);
	for (q = 0, j = 0; j < nv; j++)
		for (i = 0; i < nu; i++, q++)
			z[(size_t)(j + p->j0)*p->g.nu + i + p->i0] = p->work[q];
}
