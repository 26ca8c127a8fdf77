/* lhinterp - interpolation between two pairs (lambda, H) */
#include <stdlib.h>
#include <string.h>

#include "shared/cmd.h"
#include "lhinterp/morph.h"

static const char text[] =
"usage: lhinterp -t T[,T..] | -n FRAMES [OPTIONS] A B >lh.lhg\n"
"Interpolates between two grids of equal size and with equal channels (- is stdin).  Writes\n"
"(1-t) A + t B: lambda and H, the boundary band, the start, the height T of the chart and all\n"
"other channels, equations (20)-(22).  t = 0 gives A's numbers exactly, t = 1 B's.\n"
"  -t, --at=T[,T..]   a grid for each T as t, 0..1, in the order given\n"
"  -n, --frames=N     N grids, t = 0, 1/(N-1), .., 1, as one stream; 2..1000000\n"
"  -e, --ease         slow at both ends: t^2 (3 - 2t) in place of every t\n"
"  -l, --landmarks=FILE  match the boundaries by landmarks (below), not by equal place on the\n"
"                     rectangle\n"
"  -s, --scale        first scale B about the origin to the area of A: channels in length are\n"
"                     multiplied by sqrt(area of A/area of B), those in 1/length divided by it\n"
"  -a, --align        first move B rigidly onto A, by least squares of the distances between\n"
"                     corresponding boundary points over arc length, without reflection: moves\n"
"                     x y z and every NAME.x NAME.y NAME.z in the unit length.  Closed surfaces\n"
"                     by all nodes of the start, over the area\n"
CMD_USAGE
"Metadata that are equal in A and B are kept, others are removed; t is added.  The history has\n"
"the steps of both, marked A and B.  Without landmarks a note is printed if B's boundary would\n"
"fit A's clearly better with another of its corners first, or a closed B with its cones in\n"
"another order.  A and B should have the same unit\n"
"of length and similar size; otherwise there is no good surface between them.  Memory: three\n"
"grids, for any number of frames.\n"
"FILE has one landmark on each line, at least one, in counterclockwise order.  A landmark is\n"
"two numbers, a place on the boundary of A and one on that of B; or six, a point x y z for A\n"
"and one for B, each replaced by the nearest boundary point.  A place, 0 <= place < 4, is the\n"
"number of a side (0 bottom, 1 right, 2 top, 3 left) plus the fraction of that side, in u or v,\n"
"passed counterclockwise; 0 1 2 3 are the corners.  # begins a comment.  Between landmarks, and\n"
"from the last to the first, equal shares of arc length correspond (33)-(34).  Corresponding\n"
"points of A and B are joined by a line in space (20).  The point at t divides this line in the\n"
"ratio t : 1-t, and its place on the rectangle divides their two places in the same ratio.\n"
"lambda and H are interpolated at the same place of the rectangle.  lh2grid uses the boundary\n"
"curve only, which is exact; the inner rings of the band and the start are moved with it (Coons\n"
"patch).\n"
"Example: lhinterp --scale --align -n 20 a.lhg b.lhg | lh2grid -o morph.lhg\n";

static const struct option longopt[] = {
	{ "at",        required_argument, NULL, 't' },
	{ "frames",    required_argument, NULL, 'n' },
	{ "ease",      no_argument,       NULL, 'e' },
	{ "landmarks", required_argument, NULL, 'l' },
	{ "scale",     no_argument,       NULL, 's' },
	{ "align",     no_argument,       NULL, 'a' },
	CMD_LONGOPT
};

/* The numbers of the list of -t, to be freed; *n is their count. */
static double *
opt_times(const char *list, int *n)
{
	char *copy = cmd_alloc(strlen(list) + 1, 1), *word = copy, *comma;
	double *t = cmd_alloc(strlen(list) + 1, sizeof *t);

	strcpy(copy, list);
	for (*n = 0; word; word = comma) {
		if ((comma = strchr(word, ',')))
			*comma++ = '\0';
		t[(*n)++] = opt_double(word, 0, 1, "at");
	}
	free(copy);
	return t;
}

static double
eased(double t)
{
	return t*t*(3 - 2*t);
}

int
main(int argc, char *argv[])
{
	int opt, frames = 0, ease = 0, scale = 0, align = 0, k, n = 0;
	const char *landmarks = NULL;
	double *at = NULL, t;
	Morph m;
	Lhg g;

	cmd_begin("lhinterp", text);
	while ((opt = cmd_getopt(argc, argv, "t:n:el:sa", longopt)) != -1)
		switch (opt) {
		case 't': free(at); at = opt_times(optarg, &n); break;
		case 'n': frames = opt_long(optarg, 2, LHG_MAXFRAMES, "frames"); break;
		case 'e': ease = 1; break;
		case 'l': landmarks = optarg; break;
		case 's': scale = 1; break;
		case 'a': align = 1; break;
		}
	if (!at == !frames)
		misuse("need either -t T or -n FRAMES");
	cmd_operands(argc, argv, 2, 2);
	cmd_binary_output();

	morph_open(&m, argv[optind], argv[optind+1], landmarks, scale, align);
	n = frames ? frames : n;
	for (k = 0; k < n; k++) {
		t = frames ? k/(n - 1.0) : at[k];
		morph_at(&m, ease ? eased(t) : t, k + 1, n, &g);
		cmd_write(&g);
		lhg_free(&g);
	}
	morph_free(&m);
	free(at);
	return cmd_end();
}
