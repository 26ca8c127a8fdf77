/* polish.c - repeated conformal maps of a grid onto itself. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../grid/bicubic.h"
#include "gridlaplace.h"
#include "inverse.h"
#include "../grid/lambdah.h"
#include "../grid/stencil.h"
#include "polish.h"
#include "../base/stats.h"

/* Polishing has two stages.  The first also works far from conformal, and for most surfaces it is
 * the only one.  If it leaves a mean Beltrami modulus above UNDONE (surfaces that turn much within
 * a cell), the second stage goes on until the grid is as conformal as differences at nodes can
 * measure; averages over cells lose some accuracy by it.  A round gains nothing if its mean is not
 * below `worth` times the least mean before. */
static const struct { int metric; double worth; } STAGE[] = {
	{ GRIDLAPLACE_CELLS, 0.85 }, { GRIDLAPLACE_NODES, 0.97 }
};
enum { STAGES = 2, PATIENCE = 3 };
static const double UNDONE = 4e-3;
static const double UNRESOLVED = 0.05;  /* if the mean is larger after one round, the cells are too
                                         * large for the surface, more rounds would amplify rounding
                                         * errors, and the start is kept */
static const double FOLDED = 2e-3;      /* if the mean is above this, the first stage ends after
                                         * PATIENCE rounds without gain, otherwise after one: from a
                                         * start with folds the mean may rise at first */

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

/* Whether node p lies on an open side. */
static int
on_border(Chart g, int p)
{
	return !stencil_is_inner(g, p%g.nu, p/g.nu);
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
		chartmap_clamp(map, on_border(g, p), &a->x[p], &a->y[p]);
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
		chartmap_clamp(&a->map, on_border(a->g, p), &b->x[p], &b->y[p]);
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
	double  mean;           /* mean modulus of the Beltrami coefficient */
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

static void
state_copy(const State *from, State *to)
{
	size_t n = (size_t)from->grid.g.nu*from->grid.g.nv;

	to->grid.g = from->grid.g;
	to->grid.map = from->grid.map;
	to->mean = from->mean;
	memcpy(to->grid.phi[0], from->grid.phi[0], 5*n*sizeof(double));
	copy_points(from->n, from->pu, from->pv, to);
}

/* Does one round, from a to b; mu as in mean_beltrami. */
static int
advance(const Sampler *sampler, int metric, const State *a, State *b, Shift *shift, double *mu)
{
	int e = find_shift(&a->grid, metric, shift);

	if (e)
		return e;
	copy_points(a->n, a->pu, a->pv, b);
	e = resample(sampler, &a->grid, shift, &b->grid);
	if (e)
		return e;
	carry_points(a->grid.g, shift, b->n, b->pu, b->pv);
	b->mean = mean_beltrami(&b->grid, mu);
	return 0;
}

/* The stage of the next round, after `idle` rounds without gain in this one.  A new stage
 * begins with the best grid. */
static int
next_stage(int stage, const State *best, State *now, int *idle)
{
	if (*idle < (stage == 0 && best->mean > FOLDED ? PATIENCE : 1))
		return stage;
	*idle = 0;
	state_copy(best, now);
	return best->mean > UNDONE ? stage + 1 : STAGES;
}

/* The share of the mean after the first round below which the later ones have to bring it.  Limbs lie at cones, and
 * their tips are never conformal on few cells: each round takes nodes away from there.  The first takes out what the map
 * lacks; the others have to pay. */
static double
worthwhile(Chart g)
{
	return g.kind->cones ? 0.5 : 1;
}

/* best   in: the start; out: the round with the least mean, or the first if the others are not worthwhile
 * first  workspace for the first round
 * done   out: the number of that round, if any round lowered the mean */
static int
iterate(const Sampler *sampler, State *best, State work[2], State *first, int rounds, double enough, Shift *shift,
	double *mu, int *done)
{
	int k, e, idle = 0, stage = 0;
	State *now, *next;

	best->mean = mean_beltrami(&best->grid, mu);
	state_copy(best, &work[0]);
	for (k = 0; k < rounds && best->mean > enough && stage < STAGES; k++) {
		now = &work[k%2], next = &work[(k+1)%2];
		e = advance(sampler, STAGE[stage].metric, now, next, shift, mu);
		if (e)
			return e;
		if (k == 0 && next->mean > UNRESOLVED)
			break;
		idle = next->mean < STAGE[stage].worth*best->mean ? 0 : idle + 1;
		if (next->mean < best->mean) {
			state_copy(next, best);
			*done = k + 1;
		}
		if (k == 0)
			state_copy(best, first);
		stage = next_stage(stage, best, next, &idle);
	}
	if (*done > 1 && !(best->mean < worthwhile(best->grid.g)*first->mean)) {
		state_copy(first, best);
		*done = 1;
	}
	return 0;
}

int
polish(const Sampler *sampler, Grid *a, int rounds, double enough, int n, double *pu, double *pv,
	int *done)
{
	size_t nodes = (size_t)a->g.nu*a->g.nv;
	double *room = malloc(3*nodes*sizeof *room);
	Shift shift = { room, room + nodes, 0 };
	State best = { *a, n, pu, pv, 0 }, work[2], first;
	int e = state_alloc(&work[0], a->g, n), e1 = state_alloc(&work[1], a->g, n), e2 = state_alloc(&first, a->g, n);

	*done = 0;
	e = e || e1 || e2 || !room ? POLISH_ENOMEM : 0;
	if (!e && rounds > 0)
		e = iterate(sampler, &best, work, &first, rounds, enough, &shift, room + 2*nodes, done);
	*a = best.grid;
	state_free(&work[0]);
	state_free(&work[1]);
	state_free(&first);
	free(room);
	return e ? POLISH_ENOMEM : 0;
}
