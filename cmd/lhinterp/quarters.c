/* quarters.c - which corner of one border fits the first corner of another. */
#include <math.h>
#include <stdlib.h>

#include "../../lib/base/procrustes.h"
#include "quarters.h"
#include "turns.h"

enum { SIDE = 128 };                    /* points on each side */

/* Sets x to SIDE points of each side, evenly spaced in place (border.h), from the beginning of side
 * `first` on.  Then moves them to mean 0 and scales them to root mean square 1. */
static void
sample(const Border *b, int first, double *x)
{
	double mean[3] = { 0 }, sum = 0;
	int i;

	for (i = 0; i < 4*SIDE; i++)
		border_at(b, fmod(first + (double)i/SIDE, 4), x + 3*i);
	for (i = 0; i < 12*SIDE; i++)
		mean[i%3] += x[i]/(4*SIDE);
	for (i = 0; i < 12*SIDE; i++)
		sum = hypot(sum, x[i] -= mean[i%3]);
	for (i = 0; i < 12*SIDE; i++)
		x[i] *= sqrt(4*SIDE)/sum;
}

void
quarters_check(const CmdInput *A, const Border *a, const CmdInput *B, const Border *b, int aligned)
{
	double *x = cmd_alloc(2*12*SIDE, sizeof *x), *y = x + 12*SIDE, rms[4], angle[4];
	int k, best;
	Rigid r;

	sample(a, 0, x);
	for (k = 0; k < 4; k++) {
		sample(b, k, y);
		if (procrustes(4*SIDE, NULL, x, y, &r, &rms[k]))
			break;
		angle[k] = rigid_angle(&r);
		detail("%s: %d quarter turns: borders %.3g of their size apart, %.3g degrees", B->name, k, rms[k],
		    angle[k]*180/M_PI);
	}
	free(x);
	if (k < 4)
		return;
	best = turns_better(rms, angle, aligned);
	if (best)
		note("%s fits %s better with corners %d,%d,%d,%d (mesh2rect --like): the boundaries are "
		    "then %.2g of their size apart after a rotation by %.0f degrees, now %.2g after %.0f", B->name, A->name,
		    best%4 + 1, (best + 1)%4 + 1, (best + 2)%4 + 1, (best + 3)%4 + 1, rms[best], angle[best]*180/M_PI,
		    rms[0], angle[0]*180/M_PI);
}
