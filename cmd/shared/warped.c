/* warped.c - grids that were brought to the chart of another. */
#include <stddef.h>

#include "warped.h"

const char *
warped_H(const Lhg *g)
{
	char value[LHG_KEYLEN];

	return lhg_getmeta(g, "warped", value, sizeof value)
	    ? "the grid is warped, so H is (L+N)/(2 lambda^2) and not the mean curvature" : NULL;
}
