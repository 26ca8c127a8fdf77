/* lh2grid - the surface that fits a conformal factor and a mean curvature best */
#include <math.h>

#include "../lib/frame.h"
#include "cmd.h"

static const char text[] =
"usage: lh2grid [LH] >grid.lhg\n"
"reads channels lambda H and band.x band.y band.z (at least three rings of positions);\n"
"writes x y z and drops what it read, the start start.x start.y start.z too; other\n"
"channels and metadata pass through\n"
CMD_USAGE
"Least squares of the Codazzi equations, then of the natural frame equations (13), then\n"
"of x_u and x_v, on cell centres, with the band as given data (the paper's method).  A\n"
"grid of 257 x 257 nodes takes 0.32 GB, one of 513 x 513 1.4 GB.\n";

static const struct option longopt[] = { CMD_LONGOPT };

static void
check_positive(const CmdInput *in, const Lhg *g, const double *lambda)
{
	int p;

	for (p = 0; p < g->nu*g->nv; p++)
		if (!(lambda[p] > 0))
			die("%s: lambda is %g at node (%d,%d), must be positive",
			    in->name, lambda[p], p%g->nu, p/g->nu);
}

/* The band set into whole grids x y z. */
static void
start_from_band(const CmdInput *in, Lhg *g, double *phi[3])
{
	static const char *const band[3] = { "band.x", "band.y", "band.z" }, *const name[3] = { "x", "y", "z" };
	LhgChannel *b;
	int c;

	for (c = 0; c < 3; c++) {
		cmd_need(in, g, band[c], LHG_BORDER);
		lhg_drop(g, name[c]);
		b = lhg_find(g, band[c]);
		if (b->step < FRAME_BAND)
			die("%s: channel %s has %d rings, need %d", in->name, band[c], b->step, FRAME_BAND);
		phi[c] = cmd_add(g, name[c], b->unit, LHG_GRID, 0);
		lhg_scatter(g, b, phi[c]);
	}
}

static void
solve(const CmdInput *in, Chart g, const double *lambda, const double *H, double *phi[3])
{
	SpdReport report = { 0, 0 };
	int at = 0, p;

	switch (frame_surface(g, lambda, H, phi, &at, &report)) {
	case 0: break;
	case FRAME_EBAND: die("%s: the band has no tangent plane at node (%d,%d)", in->name, at%g.nu, at/g.nu);
	case SPD_ENOMEM: die("%s: no memory: the factor of %d x %d nodes wants %.0f bytes",
	    in->name, g.nu, g.nv, report.bytes);
	case SPD_ELARGE: die("%s: %d x %d nodes are more than the solver can number", in->name, g.nu, g.nv);
	default: die("%s: the normal equations are not positive definite at row %d", in->name, report.column);
	}
	for (p = 0; p < g.nu*g.nv; p++)
		if (!isfinite(phi[0][p] + phi[1][p] + phi[2][p]))
			die("%s: the solution is not finite at node (%d,%d)", in->name, p%g.nu, p/g.nu);
}

static void
convert(const CmdInput *in, Lhg *g)
{
	static const char *const used[] = { "lambda", "H", "band.x", "band.y", "band.z",
	    "start.x", "start.y", "start.z" };
	const double *lambda = cmd_need(in, g, "lambda", LHG_GRID), *H = cmd_need(in, g, "H", LHG_GRID);
	Chart chart = { g->nu, g->nv, g->T };
	double *phi[3];
	size_t i;

	check_positive(in, g, lambda);
	start_from_band(in, g, phi);
	cmd_progress("frame %d of %d, %d x %d nodes", g->frame, g->frames, g->nu, g->nv);
	solve(in, chart, lambda, H, phi);
	for (i = 0; i < sizeof used/sizeof *used; i++)
		lhg_drop(g, used[i]);
}

int
main(int argc, char *argv[])
{
	CmdInput in;
	Lhg g;

	cmd_begin("lh2grid", text);
	while (cmd_getopt(argc, argv, "", longopt) != -1)
		;
	cmd_operands(argc, argv, 0, 1);
	cmd_binary_output();

	cmd_open(&in, argv[optind]);
	while (cmd_read(&in, &g)) {
		convert(&in, &g);
		cmd_write(&g);
		lhg_free(&g);
	}
	return cmd_end();
}
