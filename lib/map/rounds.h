/* rounds.h - how many rounds of polishing a grid gets, and which one is kept. */
#ifndef ROUNDS_H
#define ROUNDS_H

enum { ROUNDS_GRIDS = 3 };      /* numbers of grids: 0 is the given one, and the result */

/* One kind of grid, held ROUNDS_GRIDS times. */
typedef struct Rounds {
	/* One round from grid `from` to grid `to`, by the metric of gridlaplace.h.  *mean: the mean modulus of the Beltrami
	 * coefficient of the new grid.  Returns 0 or an error. */
	int  (*advance)(void *of, int metric, int from, int to, double *mean);
	void (*copy)(void *of, int from, int to);
	void *of;
} Rounds;

/* At most `most` rounds, as polish.h says.  mean: of grid 0.  *done: the round that is now grid 0.  Returns 0 or the
 * error of a round. */
int rounds(const Rounds *r, int most, double enough, double mean, int *done);

#endif
