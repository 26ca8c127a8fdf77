/* polish.c - repeated conformal maps of a grid onto itself. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../grid/bicubic.h"
#include "gridlaplace.h"
#include "harmonic.h"
#include "inverse.h"
#include "../grid/lambdah.h"
#include "../grid/stencil.h"
#include "polish.h"
#include "rounds.h"
#include "../base/stats.h"

static int
grid_alloc(Grid *a, Chart g)
{
	size_t n = (size_t)g.nu*g.nv;
	int c;

	a->g = g;
	a->phi[0] = malloc(5*n*sizeof *a->phi[0]);
	if (!a->phi[0])
		return POLISH_ENOMEM;
	for (c = 1; c < 3; c++)
		a->phi[c] = a->phi[0] + c*n;
	a->x = a->phi[0] + 3*n;
	a->y = a->phi[0] + 4*n;
	return 0;
}

/* Samples the mesh at the places of the nodes. */
static int
sample(const Sampler *s, Grid *a)
{
	int n = a->g.nu*a->g.nv, p, e = POLISH_ENOMEM;
	double *x = malloc(2*(size_t)n*sizeof *x), *y = x + n;

	if (x) {
		#pragma omp parallel for schedule(static)
		for (p = 0; p < n; p++)
			chartmap_point(&a->map, a->x[p], a->y[p], &x[p], &y[p]);
		e = sampler_points(s, n, x, y, a->phi) ? POLISH_ENOMEM : 0;
	}
	free(x);
	return e;
}

/* The open sides on which node p lies (harmonic.h). */
static int
sides_of(Chart g, int p)
{
	const int (*joined)[2] = g.kind->joined;
	int i = p%g.nu, j = p/g.nu;

	return (i == 0 && !joined[0][0] ? SIDE_LEFT : 0) | (i == g.nu - 1 && !joined[0][1] ? SIDE_RIGHT : 0)
	    | (j == 0 && !joined[1][0] ? SIDE_BOTTOM : 0) | (j == g.nv - 1 && !joined[1][1] ? SIDE_TOP : 0);
}

int
grid_init(Grid *a, const ChartMap *map, int nu, int nv, const Sampler *s)
{
	const Chart g = { nu, nv, map->chart_T, map->kind };
	const int (*joined)[2] = g.kind->joined;
	int n = nu*nv, p;

	if (grid_alloc(a, g))
		return POLISH_ENOMEM;
	a->map = *map;
	#pragma omp parallel for schedule(static)
	for (p = 0; p < n; p++) {
		chartmap_place(map, (p%nu + 0.5*joined[0][0])/chart_steps(g, 0),
		    g.T*((p/nu + 0.5*joined[1][0])/chart_steps(g, 1)), &a->x[p], &a->y[p]);
		chartmap_clamp(map, sides_of(g, p), &a->x[p], &a->y[p]);
	}
	if (!sample(s, a))
		return 0;
	grid_free(a);
	return POLISH_ENOMEM;
}

void
grid_free(Grid *a)
{
	free(a->phi[0]);
	a->phi[0] = NULL;
}

static int
find_shift(const Grid *a, int metric, Shift *s)
{
	double Ea, Eb;
	GridLaplace l;
	int e = gridlaplace_init(&l, a->g, a->phi, metric), e1 = 0;

	if (e)
		return e;
#pragma omp parallel sections
	{
#pragma omp section
		e = gridlaplace_shift(&l, 0, s->du, &Ea);
#pragma omp section
		e1 = gridlaplace_shift(&l, 1, s->dv, &Eb);
	}
	gridlaplace_free(&l);
	if (e || e1)
		return e ? e : e1;
	s->T = sqrt(Ea/Eb);
	return 0;
}

static int
resample(const Sampler *sampler, const Grid *a, const Shift *s, Grid *b)
{
	int n = a->g.nu*a->g.nv, p;

	b->g = a->g;
	b->map = a->map;
	b->g.T = s->T;
	if (shift_inverse(a->g, s, b->x, b->y))
		return POLISH_ENOMEM;
	#pragma omp parallel for schedule(static)
	for (p = 0; p < n; p++) {
		Bicubic at = bicubic_at(a->g, b->x[p], b->y[p]);

		b->x[p] = bicubic_value(&at, a->x);
		b->y[p] = bicubic_value(&at, a->y);
		chartmap_clamp(&a->map, sides_of(a->g, p), &b->x[p], &b->y[p]);
	}
	return sample(sampler, b);
}

/* The mean modulus of the Beltrami coefficient.  mu: workspace, one number for each inner node. */
static double
mean_beltrami(const Grid *a, double *mu)
{
	beltrami(a->g, (const double *const *)a->phi, mu);
	return stats_mean(stencil_inner_count(a->g), mu);
}

/* A grid and the points that move with it. */
typedef struct State {
	Grid    grid;
	int     n;
	double *pu, *pv;
} State;

static int
state_alloc(State *s, Chart g, int n)
{
	*s = (State){ .n = n };
	s->pu = malloc(2*(size_t)n*sizeof *s->pu + 1);
	s->pv = s->pu + n;
	return s->pu && !grid_alloc(&s->grid, g) ? 0 : POLISH_ENOMEM;
}

static void
state_free(State *s)
{
	grid_free(&s->grid);
	free(s->pu);
}

static void
copy_points(int n, const double *pu, const double *pv, State *to)
{
	if (n == 0)
		return;
	memcpy(to->pu, pu, n*sizeof *pu);
	memcpy(to->pv, pv, n*sizeof *pv);
}

/* What the rounds work on. */
typedef struct Polishing {
	const Sampler *sampler;
	State  state[ROUNDS_GRIDS];
	Shift  shift;
	double *mu;             /* as in mean_beltrami */
} Polishing;

static void
copy(void *of, int i, int k)
{
	const State *from = &((Polishing *)of)->state[i];
	State *to = &((Polishing *)of)->state[k];
	size_t n = (size_t)from->grid.g.nu*from->grid.g.nv;

	to->grid.g = from->grid.g;
	to->grid.map = from->grid.map;
	memcpy(to->grid.phi[0], from->grid.phi[0], 5*n*sizeof(double));
	copy_points(from->n, from->pu, from->pv, to);
}

/* Does one round, from grid i to grid k. */
static int
advance(void *of, int metric, int i, int k, double *mean)
{
	Polishing *p = of;
	State *a = &p->state[i], *b = &p->state[k];
	int e = find_shift(&a->grid, metric, &p->shift);

	if (e)
		return e;
	copy_points(a->n, a->pu, a->pv, b);
	e = resample(p->sampler, &a->grid, &p->shift, &b->grid);
	if (e)
		return e;
	carry_points(a->grid.g, &p->shift, b->n, b->pu, b->pv);
	*mean = mean_beltrami(&b->grid, p->mu);
	return 0;
}

int
polish(const Sampler *sampler, Grid *a, int most, double enough, int n, double *pu, double *pv,
	int *done)
{
	size_t nodes = (size_t)a->g.nu*a->g.nv;
	double *room = malloc(3*nodes*sizeof *room);
	Polishing p = { sampler, { { *a, n, pu, pv } }, { room, room + nodes, 0 }, room + 2*nodes };
	Rounds r = { advance, copy, &p };
	int e = room ? 0 : POLISH_ENOMEM, k;

	*done = 0;
	for (k = 1; k < ROUNDS_GRIDS; k++)
		if (state_alloc(&p.state[k], a->g, n))
			e = POLISH_ENOMEM;
	if (!e && most > 0)
		e = rounds(&r, most, enough, mean_beltrami(a, p.mu), done);
	*a = p.state[0].grid;
	for (k = 1; k < ROUNDS_GRIDS; k++)
		state_free(&p.state[k]);
	free(room);
	return e ? POLISH_ENOMEM : 0;
}
