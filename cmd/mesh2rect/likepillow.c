/* likepillow.c - the grid to which a closed surface is to correspond. */
#include <math.h>

#include "../shared/chartof.h"
#include "../shared/range.h"
#include "likepillow.h"

enum { LEAST = 6 };      /* nodes in each direction, for splines round the cones */

static const double CLEAR = 1.25;       /* a fit with more than this times the distance of the best is clearly worse */
static const double FAR = 0.3;          /* a distance, over that from the middle, from which on surfaces are unlike */

/* Points phi to the positions of g: x y z or the start. */
static void
find_positions(const CmdInput *in, const Lhg *g, const double *phi[3])
{
	static const char *const name[2][3] = { { "x", "y", "z" }, { "start.x", "start.y", "start.z" } };
	int start = !lhg_find(g, "x"), c;

	for (c = 0; c < 3; c++) {
		if (start && !lhg_find(g, name[1][c]))
			die("%s: neither x y z nor start.x start.y start.z for --like: run grid2lh without --no-lattice", in->name);
		phi[c] = cmd_need(in, g, name[start][c], LHG_GRID);
	}
	range_positions(in->name, (size_t)g->nu*g->nv, 1, phi);
}

void
likepillow_read(const char *path, const char *mesh, LikePillow *l, Chart *g, ConformalOptions *o)
{
	cmd_open(&l->in, path);
	cmd_read_one(&l->in, &l->g);
	if (l->g.chart != LHG_PILLOW)
		die("%s: is on a %s; --like needs a pillow, as %s is a closed surface", l->in.name,
		    lhg_chartname(l->g.chart), mesh);
	if (l->g.nu < LEAST || l->g.nv < LEAST)
		die("%s: %d x %d nodes, --like needs at least %d x %d on a pillow", l->in.name, l->g.nu, l->g.nv, LEAST, LEAST);
	range_height(&l->in, &l->g);
	find_positions(&l->in, &l->g, o->like.phi);
	o->like.g = chart_of(&l->g);
	g->nu = l->g.nu;
	g->nv = l->g.nv;
}

void
likepillow_report(const LikePillow *l, const Conformal *c)
{
	detail("%s: surfaces %.3g of their size apart, %.3g in the next best position", l->in.name, c->apart[0],
	    c->apart[1]);
	if (c->apart[0] > FAR)
		note("%s: the surfaces are %.2g of their size apart: too unlike for corresponding cones", l->in.name,
		    c->apart[0]);
	else if (c->apart[1] <= CLEAR*c->apart[0])
		note("%s: the surfaces fit about equally well in another position (%.3g and %.3g of their size apart): of equal "
		    "fits the one that turns the mesh less is chosen; --cones chooses otherwise", l->in.name, c->apart[0],
		    c->apart[1]);
}
