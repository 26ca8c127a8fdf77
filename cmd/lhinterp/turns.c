/* turns.c - the choice among the four ways to lay a chart onto itself. */
#include <math.h>

#include "turns.h"

static const double CLEAR = 1.5;        /* another way is clearly better than the present one if its
                                         * distance is smaller by this factor, */
static const double FAR = 0.1;          /* and the present distance is larger than this; */
static const double TURN = M_PI/3;      /* or if it rotates B less, by more than this angle */
static const double NEAR = 1.25;        /* distances within this factor count as equal */

/* The way that fits best; among equally good ones, the one that rotates B least in space. */
static int
best_turn(const double rms[TURNS], const double angle[TURNS], int aligned)
{
	int k, best = 0, chosen;

	for (k = 1; k < TURNS; k++)
		if (rms[k] < rms[best] && (aligned || angle[k] <= angle[0] + TURN))
			best = k;
	for (chosen = best, k = 0; k < TURNS; k++)
		if (rms[k] <= NEAR*rms[best] && angle[k] < angle[chosen])
			chosen = k;
	return chosen;
}

int
turns_better(const double rms[TURNS], const double angle[TURNS], int aligned)
{
	int best = best_turn(rms, angle, aligned);

	return (rms[0] > FAR && rms[0] > CLEAR*rms[best]) || angle[0] > angle[best] + TURN ? best : 0;
}
