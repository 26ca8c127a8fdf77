/* lh2grid - the surface that fits a conformal factor and a mean curvature best */
#include <stdlib.h>

#include "shared/cmd.h"
#include "lh2grid/follow.h"
#include "lh2grid/gridfit.h"
#include "lh2grid/keyframes.h"

static const char text[] =
"usage: lh2grid [OPTIONS] [LH] >grid.lhg\n"
"Computes the surface that fits a conformal factor lambda and a mean curvature H best.  Reads\n"
"channels lambda H, the boundary band.x band.y band.z and the start start.x start.y start.z;\n"
"writes x y z and removes the channels it read; others and metadata pass through.\n"
"  -m, --method=surface|frame  least squares for the positions of the nodes, or the paper's\n"
"                     frame method [surface]\n"
"  -t, --tolerance=X  surface: stop when the root mean square movement of the nodes in a step\n"
"                     is less than X times the square root of the area [5e-5]\n"
"  -s, --steps=N      surface: give up after N steps on the full grid, 1..10000 [200]\n"
"  -b, --boundary=held|free  surface: keep the boundary on the curve of the band, or solve for\n"
"                     it too [held]\n"
"  -f, --follow       surface: each frame of a stream after the first starts from the surface\n"
"                     of the previous frame, not from its own start\n"
"  -k, --keyframes=N  surface: solve the first frame of a stream, every N-th after it, 2..1000,\n"
"                     and the last independently.  Frames between two of these start, on the\n"
"                     full grid, with the interpolated detail that it adds to both\n"
"      --no-start     do not use start.x start.y start.z\n"
"      --no-place     do not use place.x place.y place.z\n"
"      --ideal        do not use nu1 nu2 tau1 tau2 (grid2lh --residual)\n"
CMD_USAGE
"The surface method minimises, with the boundary curve held,\n"
"  |Delta phi - 2 lambda^2 H n|^2 + w^2 (the metric minus lambda^2)^2\n"
"by Gauss-Newton steps, first on a grid of 4225 nodes or a few more, then on grids twice as\n"
"fine, up to the full grid.  The start only selects one of the surfaces that have this lambda, H\n"
"and boundary.  A place is a start on the full grid; filtered by lhfft --scale or --relief, it also\n"
"holds the waves that the filter left; shorter ones follow lambda and H.  Without a start, the\n"
"frame method computes one on the coarsest grid, from three rings of the band; on the sock it is\n"
"a cap, on the pillow a sphere.  A closed surface is put where the start is.\n"
"With --boundary=free the border nodes are unknowns too, determined by the metric alone.  The\n"
"surface is then moved rigidly so that its border is nearest to that of the band; without a\n"
"band, so that the surface is nearest to the start.  lambda and H determine a surface up to\n"
"rigid motion, except for surfaces that can bend and keep both (constant H, developables): near\n"
"these the result is poorly determined, and held is better.  free takes four to ten times as\n"
"long, for a morph longer, and its error is two to twenty times as large.  A morph whose\n"
"boundary turns or folds on the way needs --boundary=free --follow.\n"
"--keyframes=6 halves the time of a morph between similar surfaces (two faces: 0.01 % of the\n"
"square root of the area apart).  For very different ones it saves a tenth, and another of the\n"
"surfaces that fit such data may be found (two teeth: 0.1 to 0.4 % apart).\n"
"The metadata misfit, change and stopped say how well it fits and how the steps ended.  Steps\n"
"that creep go on while the last ten move the surface by over 10 X, at least 5e-4 (free: .01);\n"
"then they are noted.  Without convergence nothing is written.  The metadatum\n"
"deviation is the largest distance from an unfiltered place; over 1 % is noted.\n"
"Memory: 31 numbers for each node, up to 61 where the grid leaves much unresolved; in all 25 to\n"
"40 MB for 257 x 257 nodes, 75 to 105 MB for 513 x 513.  --follow adds 3 numbers for each node,\n"
"--keyframes 9 + 2 N.\n"
"The frame method solves the Codazzi equations, the natural frame equations (13) and those of\n"
"x_u and x_v by least squares on cell centres, with three rings of the band given.  257 x 257\n"
"nodes need 0.32 GB, 513 x 513 1.4 GB.\n"
"-v prints steps, energy and cost in vector Poisson solves (six sine transforms each).\n"
"Example: lhfft --scale=6 face.lhg | lh2grid | grid2mesh -o smooth.ply\n";

static const struct option longopt[] = {
	{ "method",    required_argument, NULL, 'm' },
	{ "tolerance", required_argument, NULL, 't' },
	{ "steps",     required_argument, NULL, 's' },
	{ "boundary",  required_argument, NULL, 'b' },
	{ "follow",    no_argument,       NULL, 'f' },
	{ "keyframes", required_argument, NULL, 'k' },
	{ "no-start",  no_argument,       NULL, 'S' },
	{ "no-place",  no_argument,       NULL, 'P' },
	{ "ideal",     no_argument,       NULL, 'i' },
	CMD_LONGOPT
};

static void
convert_frame(const CmdInput *in, Lhg *g, const SurfaceFit *o)
{
	free(gridfit(in, g, GRIDFIT_SURFACE, 0, o));
}

int
main(int argc, char *argv[])
{
	SurfaceFit o = { .tolerance = SURFACEFIT_TOLERANCE, .steps = 200 };
	int opt, method = GRIDFIT_SURFACE, chained = 0, every = 0;
	Before before = { 0 };
	double *phi;
	CmdInput in;
	Lhg g;

	cmd_begin("lh2grid", text);
	while ((opt = cmd_getopt(argc, argv, "m:t:s:b:fk:", longopt)) != -1)
		switch (opt) {
		case 'm': method = opt_word(optarg, "surface\0frame\0", "method"); break;
		case 't': o.tolerance = opt_double(optarg, 1e-14, 1, "tolerance"); break;
		case 's': o.steps = opt_long(optarg, 1, 10000, "steps"); break;
		case 'b': o.free = opt_word(optarg, "held\0free\0", "boundary"); break;
		case 'f': chained = o.follows = 1; break;
		case 'k': every = opt_long(optarg, 2, KEYFRAMES_MOST, "keyframes"); break;
		case 'S': o.no_start = 1; break;
		case 'P': o.no_place = 1; break;
		case 'i': o.ideal = 1; break;
		}
	if (method == GRIDFIT_FRAME && (o.free || chained || every))
		misuse("--%s is for the surface method", o.free ? "boundary=free" : chained ? "follow" : "keyframes");
	if (every && (o.free || chained))
		misuse("--keyframes and --%s exclude each other", o.free ? "boundary=free" : "follow");
	if (chained && o.no_start)
		misuse("--follow and --no-start exclude each other");
	cmd_operands(argc, argv, 0, 1);
	cmd_binary_output();

	cmd_open(&in, argv[optind]);
	if (every) {
		keyframes(&in, every, &o, convert_frame);
		return cmd_end();
	}
	while (cmd_read(&in, &g)) {
		if (chained)
			follow_start(&before, &in, &g);
		o.where = before.own;
		phi = gridfit(&in, &g, method, chained, &o);
		cmd_pass(&in, &g);
		if (chained)
			follow_keep(&before, &g, phi);
		else
			free(phi);
		lhg_free(&g);
	}
	follow_end(&before);
	return cmd_end();
}
