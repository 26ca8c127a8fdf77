/* polish.c - rounds of conformal maps of a grid onto itself. */
#include <math.h>
#include <stdlib.h>

#include "bicubic.h"
#include "gridlaplace.h"
#include "lambdah.h"
#include "polish.h"
#include "stats.h"

static const double WORTH = 0.97;       /* a round that leaves more is the last */

static int
grid_alloc(Grid *a, Chart g)
{
	size_t n = (size_t)g.nu*g.nv;
	int c;

	a->g = g;
	a->x = malloc(5*n*sizeof *a->x);
	if (!a->x)
		return POLISH_ENOMEM;
	a->y = a->x + n;
	for (c = 0; c < 3; c++)
		a->phi[c] = a->x + (2 + c)*n;
	return 0;
}

int
grid_init(Grid *a, Chart g, const Sampler *s)
{
	size_t n = (size_t)g.nu*g.nv, p;

	if (grid_alloc(a, g))
		return POLISH_ENOMEM;
	for (p = 0; p < n; p++) {
		a->x[p] = (p%g.nu)/(g.nu - 1.0);
		a->y[p] = g.T*((p/g.nu)/(g.nv - 1.0));
	}
	sampler_grid(s, g, a->x, a->y, a->phi);
	return 0;
}

void
grid_free(Grid *a)
{
	free(a->x);
	a->x = NULL;
}

/* The map of a grid onto itself as displacements, in nodes: node (i,j) goes to
 * (i + du, j + dv). */
typedef struct Shift {
	double *du, *dv, T;     /* T of the new chart */
} Shift;

static int
find_shift(const Grid *a, Shift *s)
{
	size_t n = (size_t)a->g.nu*a->g.nv, p;
	double Ea, Eb;
	GridLaplace l;
	int e = gridlaplace_init(&l, a->g, a->phi);

	if (e)
		return e;
	e = gridlaplace_harmonic(&l, 0, s->du, &Ea);
	if (!e)
		e = gridlaplace_harmonic(&l, 1, s->dv, &Eb);
	gridlaplace_free(&l);
	if (e)
		return e;
	s->T = sqrt(Ea/Eb);
	for (p = 0; p < n; p++) {
		s->du[p] = s->du[p]*(a->g.nu - 1) - p%a->g.nu;
		s->dv[p] = s->dv[p]*(a->g.nv - 1) - p/a->g.nu;
	}
	return 0;
}

/* The place (x,y), in nodes, that the shift brings to (i,j): fixed point of
 * x = i - du(x,y), y = j - dv(x,y), damped where the plain one does not settle. */
static void
invert(const Shift *s, Chart g, int i, int j, double *x, double *y)
{
	double dx = 1, dy = 1, w;
	Bicubic at;
	int k;

	*x = i, *y = j;
	for (k = 0; k < 200 && fmax(fabs(dx), fabs(dy)) > 1e-9; k++) {
		w = k < 30 ? 1 : 0.3;
		at = bicubic_at(g.nu, g.nv, *x, *y);
		dx = w*(i - *x - bicubic_value(&at, s->du));
		dy = w*(j - *y - bicubic_value(&at, s->dv));
		*x = fmin(fmax(*x + dx, 0), g.nu - 1);
		*y = fmin(fmax(*y + dy, 0), g.nv - 1);
	}
}

static void
resample(const Sampler *sampler, const Grid *a, const Shift *s, Grid *b)
{
	int nu = a->g.nu, nv = a->g.nv, p;

	b->g = a->g;
	b->g.T = s->T;
	#pragma omp parallel for schedule(dynamic, 256)
	for (p = 0; p < nu*nv; p++) {
		double x, y;
		Bicubic at;

		invert(s, a->g, p%nu, p/nu, &x, &y);
		at = bicubic_at(nu, nv, x, y);
		b->x[p] = fmin(fmax(bicubic_value(&at, a->x), 0), 1);
		b->y[p] = fmin(fmax(bicubic_value(&at, a->y), 0), sampler->l.T);
	}
	sampler_grid(sampler, b->g, b->x, b->y, b->phi);
}

static void
carry(Chart g, const Shift *s, int n, double *pu, double *pv)
{
	int i;

	#pragma omp parallel for schedule(static)
	for (i = 0; i < n; i++) {
		double x = pu[i]*(g.nu - 1), y = pv[i]/g.T*(g.nv - 1);
		Bicubic at = bicubic_at(g.nu, g.nv, x, y);

		pu[i] = fmin(fmax((x + bicubic_value(&at, s->du))/(g.nu - 1), 0), 1);
		pv[i] = fmin(fmax((y + bicubic_value(&at, s->dv))/(g.nv - 1), 0), 1)*s->T;
	}
}

/* mu is room for the inner nodes. */
static double
mean_beltrami(const Grid *a, double *mu)
{
	beltrami(a->g, (const double *const *)a->phi, mu);
	return stats_mean((size_t)(a->g.nu - 2)*(a->g.nv - 2), mu);
}

static void
swap(Grid *a, Grid *b)
{
	Grid c = *a;

	*a = *b;
	*b = c;
}

int
polish(const Sampler *sampler, Grid *a, int rounds, int n, double *pu, double *pv, int *done)
{
	size_t nodes = (size_t)a->g.nu*a->g.nv;
	double *work = malloc(3*nodes*sizeof *work), *mu = work + 2*nodes, before, after;
	Shift s = { work, work + nodes, 0 };
	Grid b = { .x = NULL };
	int e = work && !grid_alloc(&b, a->g) ? 0 : POLISH_ENOMEM;

	*done = 0;
	after = e ? 0 : mean_beltrami(a, mu);
	while (!e && *done < rounds) {
		before = after;
		e = find_shift(a, &s);
		if (e)
			break;
		resample(sampler, a, &s, &b);
		after = mean_beltrami(&b, mu);
		if (!(after < before))
			break;
		carry(a->g, &s, n, pu, pv);
		swap(a, &b);
		++*done;
		if (!(after < WORTH*before))
			break;
	}
	free(work);
	grid_free(&b);
	return e ? POLISH_ENOMEM : 0;
}
