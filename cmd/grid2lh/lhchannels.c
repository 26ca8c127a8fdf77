/* lhchannels.c - the channels that grid2lh writes. */
#include <stdio.h>
#include <stdlib.h>

#include "../../lib/base/stats.h"
#include "../../lib/grid/lambdah.h"
#include "../../lib/grid/stencil.h"
#include "../shared/chartof.h"
#include "../shared/exact.h"
#include "../shared/place.h"
#include "../shared/range.h"
#include "../shared/warped.h"
#include "lhchannels.h"

enum { BAND = 3 };      /* rings that the frame method of lh2grid needs */

/* Adds the positions phi as channels PREFIX.x, PREFIX.y, PREFIX.z on the nodes of this support. */
static void
add_positions(Lhg *g, const char *prefix, int support, int step, const double *const phi[3])
{
	char name[LHG_NAMELEN];
	int c;

	for (c = 0; c < 3; c++) {
		snprintf(name, sizeof name, "%s.%c", prefix, "xyz"[c]);
		lhg_drop(g, name);
		cmd_add(g, name, "length", support, step);
		lhg_gather(g, lhg_find(g, name), phi[c]);
	}
}

/* The number of grid steps between neighbouring nodes of a lattice with about n nodes along the
 * shorter side. */
static int
lattice_step(const Lhg *g, int n)
{
	int cells = (g->nu < g->nv ? g->nu : g->nv) - 1;

	return cells > n - 1 ? cells/(n - 1) : 1;
}

static void
report_beltrami(const CmdInput *in, Chart g, const double *const phi[3])
{
	size_t n = stencil_inner_count(g);
	double *mu = cmd_alloc(n, sizeof *mu);

	beltrami(g, phi, mu);
	detail("%s: residual Beltrami coefficient: median %.3g, mean %.3g, max %.3g",
	    in->name, stats_median(n, mu), stats_mean(n, mu), stats_max(n, mu));
	free(mu);
}

static void
add_residue(Lhg *g, Chart chart, const double *const phi[3], const double *lambda)
{
	static const char *const name[4] = { "nu1", "nu2", "tau1", "tau2" };
	double *f[4];
	int i;

	for (i = 0; i < 4; i++) {
		lhg_drop(g, name[i]);
		f[i] = cmd_add(g, name[i], "1", LHG_GRID, 0);
	}
	lambdah_residue(chart, phi, lambda, f, f + 2);
}

void
lhchannels(const CmdInput *in, Lhg *g, int curvature, int lattice, int place, int residual)
{
	const char *const name[3] = { "x", "y", "z" };
	Chart chart = chart_of(g);
	const double *phi[3];
	double *lambda, *H;
	LambdahFlaws flaws;
	int c;

	if (g->nu < 4 || g->nv < 4)
		die("%s: %d x %d nodes, need at least 4 x 4", in->name, g->nu, g->nv);
	for (c = 0; c < 3; c++)
		phi[c] = cmd_need(in, g, name[c], LHG_GRID);
	range_height(in, g);
	range_positions(in->name, (size_t)g->nu*g->nv, 1, phi);
	report_beltrami(in, chart, phi);
	lhg_drop(g, "lambda");
	lhg_drop(g, "H");
	lambda = cmd_add(g, "lambda", "length", LHG_GRID, 0);
	H = cmd_add(g, "H", "1/length", LHG_GRID, 0);
	flaws = lambdah(chart, phi, curvature, lambda, H);
	if (!(lambda[0] > 0))
		die("%s: the surface has no extent", in->name);
	if (warped_H(g))
		detail("%s: %s", in->name, warped_H(g));
	if (flaws.raised)
		detail("%s: %d of %d nodes have almost no tangent plane", in->name, flaws.raised, g->nu*g->nv);
	if (flaws.parallel)
		note("%s: %d nodes where phi_u and phi_v are parallel; H is 0 there", in->name, flaws.parallel);
	if (residual)
		add_residue(g, chart, phi, lambda);
	else
		lambdah_limit_corners(chart, H);
	if (residual && curvature == LAMBDAH_NORMAL && !flaws.raised)
		exact_promise(g);
	if (lhg_count(g, LHG_BORDER, 1))
		add_positions(g, "band", LHG_BORDER, BAND, phi);
	if (lattice && lhg_count(g, LHG_LATTICE, 1))
		add_positions(g, "start", LHG_LATTICE, lattice_step(g, lattice), phi);
	else if (lattice)
		add_positions(g, "start", LHG_GRID, 0, phi);
	place_drop(g);
	if (place)
		add_positions(g, "place", LHG_GRID, 0, phi);
	for (c = 0; c < 3; c++)
		lhg_drop(g, name[c]);
}
