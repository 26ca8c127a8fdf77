/* warpminimise.h - lowers the energy of a map between two charts by L-BFGS (J. Nocedal, "Updating
 * quasi-Newton matrices with limited storage", Math. Comp. 35, 1980), as libLBFGS has it.
 */
#ifndef WARPMINIMISE_H
#define WARPMINIMISE_H

#include "warpenergy.h"

/* Lowers warpenergy() from the coefficients x[2][M][M] on; x is replaced by the best found.  M is even:
 * libLBFGS takes multiples of 8 variables where it uses vector units.  If the map of x is folded on the nodes
 * of e, its displacement is halved until it is not.  Returns 0, WARP_ENOMEM, or WARP_EVALUE if even f = id
 * has no finite energy. */
int warpminimise(WarpEnergy *e, double *x);

#endif
