/* pillowmu.h - how conformal the grid of a pillow is. */
#ifndef PILLOWMU_H
#define PILLOWMU_H

#include <stdlib.h>

#include "../lib/base/stats.h"
#include "../lib/grid/lambdah.h"
#include "../lib/map/pillowgrid.h"

/* The mean of |mu| over all nodes. */
static inline double
mean_mu(const PillowGrid *a)
{
	double *mu = malloc(a->g.nu*a->g.nv*sizeof *mu), mean;

	beltrami(a->g, (const double *const *)a->phi, mu);
	mean = stats_mean(a->g.nu*a->g.nv, mu);
	free(mu);
	return mean;
}

#endif
