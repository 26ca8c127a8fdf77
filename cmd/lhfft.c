/* lhfft - multi-scale representation: drop small Fourier coefficients of lambda and H */
#include <stdlib.h>
#include <string.h>

#include "shared/cmd.h"
#include "lhfft/scales.h"
#include "lhfft/spectable.h"

enum { K_LAMBDA = 256, K_H, BENDING, NO_BENDING, SPECTABLE = CMD_UNRECORDED };

static const char text[] =
"usage: lhfft -K X[,X..] | --keep=N[,..] | --energy=SHARE[,..] | --low-pass=R[,..] [LH]\n"
"             >lh.lhg\n"
"reads and writes channels lambda H; other channels and metadata pass through.  Several\n"
"numbers make a stream of the one grid of the input: a grid for each number, in the order\n"
"given, with the number in its metadata.\n"
"  -K, --bound=X      drop the coefficients C with |C| <= X percent of the field's root\n"
"                     mean square, that is with |C|/(nodes rms) 100 <= X; 0 changes\n"
"                     nothing; X >= 0\n"
"      --K-lambda=X, --K-H=X  a bound for one field, in place of -K; without -K the\n"
"                     other field stays as it is; --K-H is for lambda H with --bending\n"
"      --raw          X is compared with |C| itself, as equation (32) is written\n"
"      --keep=N       keep the N largest coefficients of either field instead, N >= 1\n"
"      --energy=SHARE keep the largest coefficients until they hold SHARE of the energy,\n"
"                     sum |C|^2 without the mean; 0..1, 1 changes nothing\n"
"      --low-pass=R   keep the waves of up to R cycles per unit of u, the width of the\n"
"                     rectangle, in every direction; R >= 0\n"
"      --basis=dct|dft  cosines, or the complex exponentials of the paper [dct]\n"
"      --log-lambda   filter the logarithm of lambda, rms being that of the logarithm\n"
"                     minus its mean [this]\n"
"      --no-log-lambda  filter lambda itself; results below the least value before are set to\n"
"                     that value, and their number is noted\n"
"      --bending      filter lambda H in place of H: its square, integrated over the\n"
"                     rectangle, is the bending energy [this]\n"
"      --no-bending   filter H itself\n"
"      --spectrum=FILE  also write a table of the coefficients before filtering: m, n, wave\n"
"                     number (as --low-pass), |C| of lambda and of lambda H, or of H, in\n"
"                     percent (as -K);\n"
"                     m n = 0 0 is the mean, a conjugate pair has one row; the input\n"
"                     must be one grid\n"
CMD_USAGE
"The mean is never dropped.  In either basis sum |C|^2 = nodes sum f^2.  Cosines continue\n"
"a field evenly across the border.  Exponentials continue it periodically: the jump at the\n"
"border needs many waves.  The logarithm treats small and large lambda alike and keeps it\n"
"positive.  Filtering lambda H treats cells of the rectangle with much area and with little\n"
"alike.  So all three are the default.  face_neutral at\n"
"257 x 257 nodes and K = 0.5: dft of lambda and H, dct of the two, dct of log lambda and H, of\n"
"log lambda and lambda H give back 135, 111, 101, 76 % of the bending energy (the integral of\n"
"H^2), and a surface 0.49, 0.35, 0.21, 0.13 % of the square root of the area from the original\n"
"in the mean.\n"
"Under -v: how many coefficients of either field were kept.\n";

static const struct option longopt[] = {
	{ "bound",         required_argument, NULL, 'K' },
	{ "K-lambda",      required_argument, NULL, K_LAMBDA },
	{ "K-H",           required_argument, NULL, K_H },
	{ "raw",           no_argument,       NULL, 'r' },
	{ "keep",          required_argument, NULL, 'k' },
	{ "energy",        required_argument, NULL, 'e' },
	{ "low-pass",      required_argument, NULL, 'w' },
	{ "basis",         required_argument, NULL, 'b' },
	{ "log-lambda",    no_argument,       NULL, 'l' },
	{ "no-log-lambda", no_argument,       NULL, 'L' },
	{ "bending",       no_argument,       NULL, BENDING },
	{ "no-bending",    no_argument,       NULL, NO_BENDING },
	{ "spectrum",      required_argument, NULL, SPECTABLE },
	CMD_LONGOPT
};

/* Writes the grid once for each of the s->n scales, as a set. */
static void
write_scales(const CmdInput *in, Lhg *g, const Scales *s)
{
	double *lambda = cmd_need(in, g, "lambda", LHG_GRID), *H = cmd_need(in, g, "H", LHG_GRID);
	size_t n = (size_t)g->nu*g->nv;
	double *was = cmd_alloc(2*n, sizeof *was);
	int k;

	memcpy(was, lambda, n*sizeof *was);
	memcpy(was + n, H, n*sizeof *was);
	g->frames = s->n;
	for (k = 0; k < s->n; k++) {
		g->frame = k + 1;
		if (s->n > 1)
			cmd_meta(g, s->option, "%.10g", s->bound[k]);
		scales_apply(s, k, in, g);
		cmd_write(g);
		memcpy(lambda, was, n*sizeof *was);
		memcpy(H, was + n, n*sizeof *was);
	}
	free(was);
}

int
main(int argc, char *argv[])
{
	const char *table = NULL;
	CmdInput in;
	Scales s;
	int opt;
	Lhg g;

	cmd_begin("lhfft", text);
	scales_init(&s);
	while ((opt = cmd_getopt(argc, argv, "K:", longopt)) != -1)
		switch (opt) {
		case 'K': scales_set(&s, FILTER_PERCENT, "bound", optarg); break;
		case K_LAMBDA: s.lambda = opt_double(optarg, 0, 1e300, "K-lambda"); break;
		case K_H: s.H = opt_double(optarg, 0, 1e300, "K-H"); break;
		case 'r': s.raw = 1; break;
		case 'k': scales_set(&s, FILTER_KEEP, "keep", optarg); break;
		case 'e': scales_set(&s, FILTER_ENERGY, "energy", optarg); break;
		case 'w': scales_set(&s, FILTER_LOWPASS, "low-pass", optarg); break;
		case 'b': s.basis = opt_word(optarg, "dct\0dft\0", "basis"); break;
		case 'l': s.log = 1; break;
		case 'L': s.log = 0; break;
		case BENDING: s.bending = 1; break;
		case NO_BENDING: s.bending = 0; break;
		case SPECTABLE: table = optarg; break;
		}
	cmd_operands(argc, argv, 0, 1);
	scales_check(&s);
	if (table)
		opt_spectable(table);
	cmd_binary_output();

	cmd_open(&in, argv[optind]);
	if (s.n > 1 || table) {
		cmd_read_one(&in, &g);
		scales_need(&in, &g);
		if (table)
			spectable_write(table, &in, &g, &s);
		write_scales(&in, &g, &s);
		lhg_free(&g);
	} else
		while (cmd_read(&in, &g)) {
			scales_apply(&s, 0, &in, &g);
			cmd_pass(&in, &g);
			lhg_free(&g);
		}
	return cmd_end();
}
