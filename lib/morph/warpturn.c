/* warpturn.c - the rectangle turned by quarters. */
#include <stddef.h>

#include "warpturn.h"

Chart
warpturn_chart(Chart g, int turns)
{
	return turns % 2 ? (Chart){ g.nv, g.nu, 1/g.T, g.kind } : g;
}

void
warpturn_field(Chart g, int turns, const double *f, double *out)
{
	int nu = g.nu, nv = g.nv, i, j;

	for (j = 0; j < nv; j++)
		for (i = 0; i < nu; i++) {
			int i2 = turns == 0 ? i : turns == 1 ? j : turns == 2 ? nu-1-i : nv-1-j;
			int j2 = turns == 0 ? j : turns == 1 ? nu-1-i : turns == 2 ? nv-1-j : i;

			out[(size_t)j2*(turns % 2 ? nv : nu) + i2] = f[(size_t)j*nu + i];
		}
}

void
warpturn_point(Chart g, int turns, double *u, double *v)
{
	for (; turns > 0; turns--, g = warpturn_chart(g, 1)) {
		double x = *v/g.T;

		*v = (1 - *u)/g.T;
		*u = x;
	}
}

void
warpturn_back(Chart g, int turns, double *u, double *v)
{
	/* Four turns are none. */
	warpturn_point(warpturn_chart(g, turns), (WARPTURN_WAYS - turns) % WARPTURN_WAYS, u, v);
}
