/* rounds.c - two stages of rounds, and the best one. */
#include "gridlaplace.h"
#include "rounds.h"

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

enum { BEST, ONE, OTHER };       /* grids */

/* The stage of the next round, after `idle` rounds without gain in this one; `mean` is the least so far.  A new stage
 * begins with the best grid, as grid `now`. */
static int
next_stage(const Rounds *r, int stage, double mean, int now, int *idle)
{
	if (*idle < (stage == 0 && mean > FOLDED ? PATIENCE : 1))
		return stage;
	*idle = 0;
	r->copy(r->of, BEST, now);
	return mean > UNDONE ? stage + 1 : STAGES;
}

int
rounds(const Rounds *r, int most, double enough, double best, int *done)
{
	int k, e, idle = 0, stage = 0;
	double mean;

	*done = 0;
	r->copy(r->of, BEST, ONE);
	for (k = 0; k < most && best > enough && stage < STAGES; k++) {
		int now = k%2 ? OTHER : ONE, next = k%2 ? ONE : OTHER;

		e = r->advance(r->of, STAGE[stage].metric, now, next, &mean);
		if (e)
			return e;
		if (k == 0 && mean > UNRESOLVED)
			break;
		idle = mean < STAGE[stage].worth*best ? 0 : idle + 1;
		if (mean < best) {
			r->copy(r->of, next, BEST);
			best = mean;
			*done = k + 1;
		}
		stage = next_stage(r, stage, best, next, &idle);
	}
	return 0;
}
