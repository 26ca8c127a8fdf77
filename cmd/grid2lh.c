/* grid2lh - conformal factor and mean curvature of a gridded surface */
#include <stdlib.h>
#include <string.h>

#include "../lib/grid/lambdah.h"
#include "../lib/grid/stencil.h"
#include "../lib/base/stats.h"
#include "shared/chartof.h"
#include "shared/cmd.h"
#include "shared/range.h"

enum { BAND = 3 };      /* rings that the frame method of lh2grid needs */

static const char text[] =
"usage: grid2lh [--residual] [--lattice=N | --no-lattice] [GRID] >lh.lhg\n"
"Computes the conformal factor lambda and the mean curvature H of a gridded surface.  Reads\n"
"channels x y z; writes lambda H, the boundary band band.x band.y band.z (the three outer\n"
"rings of x y z) and the start start.x start.y start.z (x y z on a coarse lattice of nodes,\n"
"where lh2grid starts); other channels and metadata pass through.\n"
"  -m, --mean-curvature=normal|magnitude  H from the part of the Laplacian along the\n"
"                     normal, or from its length (the paper's (26)) [normal]\n"
"  -l, --lattice=N    the start has about N nodes along the shorter side, 2..4096 [33]\n"
"      --no-lattice   write no start\n"
"  -r, --residual     also write the residual channels, which hold how far the grid is from\n"
"                     conformal: nu1 = (|x_u|^2-|x_v|^2)/(2 lambda^2), nu2 = x_u.x_v/lambda^2,\n"
"                     tau1 = x_u.Delta x/lambda^2, tau2 = x_v.Delta x/lambda^2; with them\n"
"                     lh2grid gives back the surface itself\n"
CMD_USAGE
"H is -1 on the unit sphere if the normal x_u cross x_v points out.  On the outermost ring\n"
"lambda and H are extrapolated from the rings inside.  Near the corners |H| is limited to four\n"
"times its root mean square elsewhere (not with --residual).  -v prints median, mean and maximum\n"
"of the residual Beltrami coefficient over the inner nodes; it is 0 where the grid is conformal.\n";

static const struct option longopt[] = {
	{ "mean-curvature", required_argument, NULL, 'm' },
	{ "lattice",        required_argument, NULL, 'l' },
	{ "no-lattice",     no_argument,       NULL, 'L' },
	{ "residual",       no_argument,       NULL, 'r' },
	CMD_LONGOPT
};

/* Adds the channels PREFIX.x, PREFIX.y, PREFIX.z of this support. */
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

/* Steps between the nodes of a lattice of about n nodes along the shorter side. */
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

/* One grid: removes x y z, adds lambda, H, band, start. */
static void
convert(const CmdInput *in, Lhg *g, int curvature, int lattice, int residual)
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
	if (flaws.raised)
		detail("%s: %d of %d nodes have almost no tangent plane", in->name, flaws.raised, g->nu*g->nv);
	if (flaws.parallel)
		note("%s: %d nodes where phi_u and phi_v are parallel; H is 0 there", in->name, flaws.parallel);
	if (residual)
		add_residue(g, chart, phi, lambda);
	else
		lambdah_limit_corners(chart, H);
	add_positions(g, "band", LHG_BORDER, BAND, phi);
	if (lattice)
		add_positions(g, "start", LHG_LATTICE, lattice_step(g, lattice), phi);
	for (c = 0; c < 3; c++)
		lhg_drop(g, name[c]);
}

int
main(int argc, char *argv[])
{
	int opt, curvature = LAMBDAH_NORMAL, lattice = 33, residual = 0;
	CmdInput in;
	Lhg g;

	cmd_begin("grid2lh", text);
	while ((opt = cmd_getopt(argc, argv, "m:l:r", longopt)) != -1)
		switch (opt) {
		case 'm': curvature = opt_word(optarg, "normal\0magnitude\0", "mean-curvature"); break;
		case 'l': lattice = opt_long(optarg, 2, 4096, "lattice"); break;
		case 'L': lattice = 0; break;
		case 'r': residual = 1; break;
		}
	cmd_operands(argc, argv, 0, 1);
	cmd_binary_output();

	cmd_open(&in, argv[optind]);
	while (cmd_read(&in, &g)) {
		convert(&in, &g, curvature, lattice, residual);
		cmd_pass(&in, &g);
		lhg_free(&g);
	}
	return cmd_end();
}
