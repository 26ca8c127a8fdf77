/* channels.c - the band that lh2grid reads and the positions that it writes. */
#include <math.h>

#include "../shared/place.h"
#include "../shared/range.h"
#include "channels.h"

void
band_read(const CmdInput *in, const Lhg *g, int rings, double *phi)
{
	static const char *const band[3] = { "band.x", "band.y", "band.z" };
	LhgChannel *b;
	int c;

	for (c = 0; c < 3 && rings; c++) {
		cmd_need(in, g, band[c], LHG_BORDER);
		b = lhg_find(g, band[c]);
		if (b->step < rings)
			die("%s: channel %s has %d rings, need %d", in->name, band[c], b->step, rings);
		lhg_scatter(g, b, phi + (size_t)c*g->nu*g->nv);
		range_width(in, g, band[c]);
	}
}

/* A channel in the unit of the positions; where none tells where the surface is, lambda. */
static const LhgChannel *
positioned(const Lhg *g)
{
	const LhgChannel *c = lhg_find(g, "band.x");

	if (!c)
		c = lhg_find(g, "start.x");
	return c ? c : lhg_find(g, "lambda");
}

void
surface_replace(const CmdInput *in, Lhg *g, const double *phi)
{
	static const char *const used[] = { "lambda", "H", "band.x", "band.y", "band.z",
	    "start.x", "start.y", "start.z", "nu1", "nu2", "tau1", "tau2", "x", "y", "z" };
	size_t i, p, n = (size_t)g->nu*g->nv;
	char unit[LHG_NAMELEN], name[2] = "x";
	double *f;
	int c;

	snprintf(unit, sizeof unit, "%s", positioned(g)->unit);
	for (i = 0; i < sizeof used/sizeof *used; i++)
		lhg_drop(g, used[i]);
	for (c = 0; c < 3; c++)
		lhg_drop(g, PLACE[c]);
	for (c = 0; c < 3; c++) {
		name[0] = "xyz"[c];
		f = cmd_add(g, name, unit, LHG_GRID, 0);
		for (p = 0; p < n; p++) {
			f[p] = phi[c*n+p];
			if (!isfinite(f[p]))
				die("%s: the solution is not finite at node (%zu,%zu)", in->name, p%g->nu, p/g->nu);
		}
	}
}
