/* positions.c - the channels of a grid that hold positions. */
#include <string.h>

#include "../../lib/grid/coons.h"
#include "../shared/chartof.h"
#include "positions.h"

/* Whether channel k is the x coordinate of positions.  Sets c to this channel and those of y and
 * z. */
static int
find_triple(Lhg *g, int k, LhgChannel *c[3])
{
	char name[LHG_NAMELEN];
	size_t n = strlen(g->chan[k].name);
	int i;

	strcpy(name, g->chan[k].name);
	if (name[n-1] != 'x' || (n > 1 && name[n-2] != '.') || strcmp(g->chan[k].unit, "length") != 0)
		return 0;
	for (i = 0; i < 3; i++) {
		name[n-1] = "xyz"[i];
		c[i] = lhg_find(g, name);
		if (!c[i] || c[i]->support != g->chan[k].support || c[i]->step != g->chan[k].step
		    || strcmp(c[i]->unit, "length") != 0)
			return 0;
	}
	return 1;
}

void
positions_move(Lhg *g, const Rigid *r)
{
	LhgChannel *c[3];
	double x[3];
	size_t p;
	int k, i;

	for (k = 0; k < g->nchan; k++) {
		if (!find_triple(g, k, c))
			continue;
		for (p = 0; p < c[0]->n; p++) {
			for (i = 0; i < 3; i++)
				x[i] = c[i]->f[p];
			rigid_move(r, 1, x);
			for (i = 0; i < 3; i++)
				c[i]->f[p] = x[i];
		}
	}
}

void
positions_shift(Lhg *g, const double *d)
{
	LhgChannel *c[3];
	size_t p, node;
	double e[3];
	int k, i;

	for (k = 0; k < g->nchan; k++) {
		if (!find_triple(g, k, c))
			continue;
		for (p = 0, node = lhg_first(g, c[0]); p < c[0]->n; p++, node = lhg_next(g, c[0], node)) {
			coons(chart_of(g), d, (int)(node%g->nu), (int)(node/g->nu), e);
			for (i = 0; i < 3; i++)
				c[i]->f[p] += e[i];
		}
	}
}
