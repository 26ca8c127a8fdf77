/* lhinterp - interpolation between several pairs (lambda, H) */
#include <stdlib.h>
#include <string.h>

#include "shared/cmd.h"
#include "lhinterp/morph.h"
#include "lhinterp/weights.h"

static const char text[] =
"usage: lhinterp -t T[,T..] | -n FRAMES [OPTIONS] A B >lh.lhg\n"
"       lhinterp -w W[,W..] [OPTIONS] A B [C..] >lh.lhg\n"
"Interpolates between grids of equal size and with equal channels (- is stdin): lambda, H and the\n"
"residual channels by the rule, the boundary band, the start, the height T of the chart and all\n"
"other channels linearly, (1-t) A + t B.  t = 0 gives A's numbers exactly, t = 1 B's.\n"
"  -t, --at=T[,T..]   a grid for each T as t, 0..1, in the order given\n"
"  -n, --frames=N     N grids, t = 0, 1/(N-1), .., 1, as one stream; 2..1000000\n"
"  -w, --weights=W[,W..]  one grid, the weighted mean of all, divided by the sum of the weights,\n"
"                     which has to be positive.  A single W is for all.  Weights below 0 exaggerate:\n"
"                     -w 1.5,-0.5 goes from B through A and half as far again\n"
"  -e, --ease         slow at both ends: t^2 (3 - 2t) in place of every t\n"
"      --rule=metric|linear  metric: the logarithm of the metric and lambda H are linear in t;\n"
"                     without residual channels log lambda and lambda^2 H.  linear: the paper's\n"
"                     lambda and H (21)-(22), and the residual channels [metric]\n"
"      --cap          lower lambda where the blend has a Gauss curvature above H^2, which no surface\n"
"                     has: against jumps of a morph.  Without residual channels only\n"
"      --boundary=held|free  held: lambda (rule metric) follows the length of the boundary,\n"
"                     which is blended in space; free: not, for lh2grid --boundary=free [held]\n"
"  -l, --landmarks=FILE  match the boundaries by landmarks (below), not by equal place on the\n"
"                     rectangle; for -t and -n\n"
"  -s, --scale        first scale B about the origin to the area of A: channels in length are\n"
"                     multiplied by sqrt(area of A/area of B), those in 1/length divided by it\n"
"  -a, --align        first move B rigidly onto A, by least squares of the distances between\n"
"                     corresponding boundary points over arc length, without reflection: moves\n"
"                     x y z and every NAME.x NAME.y NAME.z in the unit length.  Closed surfaces\n"
"                     by all nodes of the start, over the area, and with the cones of B in the\n"
"                     order that fits best\n"
CMD_USAGE
"Places (place.x ..) are not blended; with residual channels they become the start, on all nodes.\n"
"With more than two grids, each is scaled and moved like B.\n"
"Metadata that are equal in all grids are kept, others are removed; t or weights is added.  The history\n"
"has the steps of all, marked A, B, ..  Without landmarks a note is printed if B's boundary would\n"
"fit A's clearly better with another of its corners first, or a closed B with its cones in\n"
"another order (--align).  A and B should have the same unit\n"
"of length and similar size; otherwise there is no good surface between them.  Memory: one grid\n"
"more than are read, and four channels.\n"
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
	{ "weights",   required_argument, NULL, 'w' },
	{ "ease",      no_argument,       NULL, 'e' },
	{ "landmarks", required_argument, NULL, 'l' },
	{ "scale",     no_argument,       NULL, 's' },
	{ "align",     no_argument,       NULL, 'a' },
	{ "rule",      required_argument, NULL, 'r' },
	{ "cap",       no_argument,       NULL, 'c' },
	{ "boundary",  required_argument, NULL, 'b' },
	CMD_LONGOPT
};

static double
eased(double t)
{
	return t*t*(3 - 2*t);
}

static void
write_frame(Morph *m, double t, int k, int n)
{
	const double w[2] = { 1 - t, t };
	Lhg g;

	morph_blend(m, w, k, n, &g);
	cmd_meta(&g, "t", "%.10g", t);
	cmd_write(&g);
	lhg_free(&g);
}

static void
write_mean(Morph *m, const double *w)
{
	char *value = cmd_alloc(m->n, 32), *end = value;
	Lhg g;
	int k;

	morph_blend(m, w, 1, 1, &g);
	for (k = 0; k < m->n; k++)
		end += sprintf(end, "%s%.6g", k ? "," : "", w[k]);
	if (end - value < LHG_MAXLINE/2)
		cmd_meta(&g, "weights", "%s", value);
	cmd_write(&g);
	lhg_free(&g);
	free(value);
}

int
main(int argc, char *argv[])
{
	int opt, frames = 0, ease = 0, k, n = 0, weights = 0, grids;
	MorphOptions o = { .rule = MORPH_METRIC };
	double *at = NULL, *w = NULL, t;
	Morph m;

	cmd_begin("lhinterp", text);
	while ((opt = cmd_getopt(argc, argv, "t:n:w:el:sa", longopt)) != -1)
		switch (opt) {
		case 't': free(at); at = opt_numbers(optarg, 0, 1, "at", &n); break;
		case 'n': frames = opt_long(optarg, 2, LHG_MAXFRAMES, "frames"); break;
		case 'w': free(w); w = opt_numbers(optarg, -1e6, 1e6, "weights", &weights); break;
		case 'e': ease = 1; break;
		case 'r': o.rule = opt_word(optarg, "metric\0linear\0", "rule"); break;
		case 'c': o.cap = 1; break;
		case 'b': o.free = opt_word(optarg, "held\0free\0", "boundary"); break;
		case 'l': o.landmarks = optarg; break;
		case 's': o.scale = 1; break;
		case 'a': o.align = 1; break;
		}
	if (!!at + !!frames + !!w != 1)
		misuse("need either -t T, -n FRAMES or -w W");
	if (w && (ease || o.landmarks))
		misuse("--%s is for -t and -n", ease ? "ease" : "landmarks");
	grids = cmd_operands(argc, argv, 2, w ? MORPH_MOST : 2);
	if (w)
		w = weights_of(w, weights, grids);
	cmd_binary_output();

	morph_open(&m, grids, argv + optind, &o);
	if (w)
		write_mean(&m, w);
	n = frames ? frames : n;
	for (k = 0; k < n; k++) {
		t = frames ? k/(n - 1.0) : at[k];
		write_frame(&m, ease ? eased(t) : t, k + 1, n);
	}
	morph_close(&m);
	free(at);
	free(w);
	return cmd_end();
}
