/* lowpass.c - two symmetric systems for the filter, by conjugate gradients.
 *
 * With B = s^2 M^-1 K,  1 + B^3 = (1 + B)(1 - B + B^2).  So the filter is two systems,
 *
 *   A1 g  = M f,   A1 = M + s^2 K,
 *   A2 f~ = M g,   A2 = M - s^2 K + s^4 K M^-1 K,
 *
 * both symmetric and positive definite.  A V-cycle V is about A1^-1.  A2 is preconditioned by V M V,
 * which is about (A1 M^-1 A1)^-1: for an eigenvalue x of B the ratio is (1 - x + x^2)/(1 + x)^2, which
 * lies between 1/4 and 1.  So about twelve steps give six digits, whatever s, lambda and the grid.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/cg.h"
#include "../base/field.h"
#include "lowpass.h"

static const double FLOOR = 1e-6;       /* of the mean of lambda^2: the least density */
static const double REDUCTION = 1e-6;   /* of the residual */
enum { MOST_CG = 1000 };

static size_t
nodes(Chart g)
{
	return (size_t)g.nu*g.nv;
}

void
lowpass_free(Lowpass *p)
{
	int i;

	multigrid_free(&p->grid);
	for (i = 0; i < LOWPASS_WORK; i++)
		free(p->work[i]);
	memset(p, 0, sizeof *p);
}

/* Allocates the workspace; work[0] is set to the density lambda^2/<lambda^2>. */
static int
workspace(Lowpass *p, const double *lambda)
{
	size_t n = nodes(p->g), q;
	double most = 0, sum = 0, x;
	int i;

	for (i = 0; i < LOWPASS_WORK; i++)
		if (!(p->work[i] = malloc(n*sizeof(double))))
			return LOWPASS_ENOMEM;
	for (q = 0; q < n; q++)
		most = fmax(most, lambda[q]);
	for (q = 0; q < n; q++)
		sum += lambda[q]/most*(lambda[q]/most);
	p->unit = most*sqrt(sum/n);
	for (q = 0; q < n; q++) {
		x = lambda[q]/p->unit;
		p->work[0][q] = fmax(x*x, FLOOR);
	}
	return 0;
}

int
lowpass_init(Lowpass *p, Chart g, int held, const double *lambda)
{
	*p = (Lowpass){ .g = g };
	if (!workspace(p, lambda) && !multigrid_init(&p->grid, g, held, p->work[0]))
		return 0;
	lowpass_free(p);
	return LOWPASS_ENOMEM;
}

double
lowpass_root_area(const Lowpass *p)
{
	size_t n = nodes(p->g), q;
	double sum = 0;

	for (q = 0; q < n; q++)
		sum += p->grid.mass[q];
	return p->unit*sqrt(sum);
}

/* f *= the mass, or its inverse, 0 at held nodes. */
static void
times_mass(Lowpass *p, int inverse, double *f)
{
	const double *m = p->grid.mass;
	size_t n = nodes(p->g), q;

	for (q = 0; q < n; q++)
		f[q] = !inverse ? m[q]*f[q] : m[q] > 0 ? f[q]/m[q] : 0;
}

/* y = A1 x, for t = s^2. */
static void
apply1(void *ctx, const double *x, double *y)
{
	Lowpass *p = ctx;
	const double *m = p->grid.mass;
	size_t n = nodes(p->g), q;

	multigrid_stiffness(&p->grid, x, y);
	for (q = 0; q < n; q++)
		y[q] = m[q]*x[q] + p->grid.t*y[q];
}

static void
precondition1(void *ctx, const double *r, double *z)
{
	multigrid_cycle(&((Lowpass *)ctx)->grid, r, z);
}

/* y = A2 x = M x + t K (t M^-1 K x - x) */
static void
apply2(void *ctx, const double *x, double *y)
{
	Lowpass *p = ctx;
	const double *m = p->grid.mass;
	double t = p->grid.t, *z = p->work[4];
	size_t n = nodes(p->g), q;

	multigrid_stiffness(&p->grid, x, z);
	times_mass(p, 1, z);
	for (q = 0; q < n; q++)
		z[q] = t*z[q] - x[q];
	multigrid_stiffness(&p->grid, z, y);
	for (q = 0; q < n; q++)
		y[q] = m[q]*x[q] + t*y[q];
}

static void
precondition2(void *ctx, const double *r, double *z)
{
	Lowpass *p = ctx;

	multigrid_cycle(&p->grid, r, p->work[4]);
	times_mass(p, 0, p->work[4]);
	multigrid_cycle(&p->grid, p->work[4], z);
}

/* f = A^-1 M f */
static void
solve(Lowpass *p, void (*apply)(void *, const double *, double *),
	void (*precondition)(void *, const double *, double *), double *f)
{
	CgSystem s = { nodes(p->g), apply, precondition, p };
	CgLimits limits = { REDUCTION, MOST_CG, HUGE_VAL, 0, 0 };
	double *r = p->work[0];

	field_scale(s.n, 1, f, r);
	times_mass(p, 0, r);
	memset(f, 0, s.n*sizeof *f);
	cg(&s, &limits, f, r, p->work[1], p->work[2], p->work[3]);
}

void
lowpass(Lowpass *p, double s, double *f)
{
	multigrid_set(&p->grid, s/p->unit*(s/p->unit));
	solve(p, apply1, precondition1, f);
	solve(p, apply2, precondition2, f);
}

void
lowpass_heat(Lowpass *p, double s, double *f)
{
	multigrid_set(&p->grid, s/p->unit*(s/p->unit)/2);
	solve(p, apply1, precondition1, f);
}
