/* grid2lh - conformal factor and mean curvature of a gridded surface */
#include "../lib/grid/lambdah.h"
#include "shared/cmd.h"
#include "grid2lh/lhchannels.h"

static const char text[] =
"usage: grid2lh [--residual] [--lattice=N | --no-lattice] [--no-place] [GRID] >lh.lhg\n"
"Computes the conformal factor lambda and the mean curvature H of a gridded surface.  Reads\n"
"channels x y z; writes lambda H, the boundary band band.x band.y band.z (the three outer\n"
"rings of x y z), the start start.x start.y start.z (x y z on a coarse lattice of nodes, where\n"
"lh2grid starts) and the place place.x place.y place.z (x y z themselves, which lhfft --scale and\n"
"--relief filter too; nothing else uses them); other channels and metadata pass through.\n"
"  -m, --mean-curvature=normal|magnitude  H from the part of the Laplacian along the\n"
"                     normal, or from its length (the paper's (26)) [normal]\n"
"  -l, --lattice=N    the start has about N nodes along the shorter side, 2..4096 [33]\n"
"      --no-lattice   write no start\n"
"      --no-place     write no place: the file has less than half the size (257 x 257 nodes: 1.2\n"
"                     in place of 2.7 MB), and --scale moves the surface farther\n"
"  -r, --residual     also write the residual channels, which hold how far the grid is from\n"
"                     conformal: nu1 = (|x_u|^2-|x_v|^2)/(2 lambda^2), nu2 = x_u.x_v/lambda^2,\n"
"                     tau1 = x_u.Delta x/lambda^2, tau2 = x_v.Delta x/lambda^2; with them\n"
"                     lh2grid gives back the surface itself\n"
CMD_USAGE
"H is -1 on the unit sphere if the normal x_u cross x_v points out.  On the outermost ring\n"
"lambda and H are extrapolated from the rings inside.  Near the corners |H| is limited to four\n"
"times its root mean square elsewhere (not with --residual).  A closed surface, on the pillow, has\n"
"no band; on the pillow and the sock the start has all nodes.  -v prints median, mean and maximum\n"
"of the residual Beltrami coefficient over the inner nodes; it is 0 where the grid is conformal.\n"
"Example: mesh2rect face.ply | grid2lh -o face.lhg\n";

static const struct option longopt[] = {
	{ "mean-curvature", required_argument, NULL, 'm' },
	{ "lattice",        required_argument, NULL, 'l' },
	{ "no-lattice",     no_argument,       NULL, 'L' },
	{ "no-place",       no_argument,       NULL, 'P' },
	{ "residual",       no_argument,       NULL, 'r' },
	CMD_LONGOPT
};

int
main(int argc, char *argv[])
{
	int opt, curvature = LAMBDAH_NORMAL, lattice = 33, place = 1, residual = 0;
	CmdInput in;
	Lhg g;

	cmd_begin("grid2lh", text);
	while ((opt = cmd_getopt(argc, argv, "m:l:r", longopt)) != -1)
		switch (opt) {
		case 'm': curvature = opt_word(optarg, "normal\0magnitude\0", "mean-curvature"); break;
		case 'l': lattice = opt_long(optarg, 2, 4096, "lattice"); break;
		case 'L': lattice = 0; break;
		case 'P': place = 0; break;
		case 'r': residual = 1; break;
		}
	cmd_operands(argc, argv, 0, 1);
	cmd_binary_output();

	cmd_open(&in, argv[optind]);
	while (cmd_read(&in, &g)) {
		lhchannels(&in, &g, curvature, lattice, place, residual);
		cmd_pass(&in, &g);
		lhg_free(&g);
	}
	return cmd_end();
}
