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
"Drops Fourier coefficients of lambda and H: small ones, or those of short waves.  Reads and\n"
"writes channels lambda H; other channels and metadata pass through.  A list of numbers makes\n"
"a stream of the one grid of the input: a grid for each number, in this order, with the number\n"
"in its metadata.  The metadatum waves says what is kept, for grid2mesh --detail=smooth: the\n"
"cycles per width up to which there are as many waves.\n"
"  -K, --bound=X      drop the coefficients C with |C| <= X percent of the field's root\n"
"                     mean square, that is with |C|/(nodes rms) 100 <= X; 0 changes\n"
"                     nothing; X >= 0\n"
"      --K-lambda=X, --K-H=X  a bound for one field, in place of -K; without -K the\n"
"                     other field is not changed.  With --bending, --K-H is for lambda H\n"
"      --raw          compare X with |C| itself, as equation (32) is written\n"
"      --keep=N       keep the N largest coefficients of each field, N >= 1\n"
"      --energy=SHARE keep the largest coefficients that hold SHARE of the energy of the\n"
"                     field, sum |C|^2 without the mean; 0..1, 1 changes nothing\n"
"      --low-pass=R   keep the waves of up to R cycles per width of the rectangle, in\n"
"                     every direction; R >= 0\n"
"      --basis=dct|dft  cosines, or the complex exponentials of the paper [dct]\n"
"      --log-lambda   filter the logarithm of lambda; rms is then that of the logarithm\n"
"                     minus its mean [this]\n"
"      --no-log-lambda  filter lambda itself; values below its minimum before are raised to\n"
"                     that minimum, and their number is noted\n"
"      --bending      filter lambda H in place of H: its square, integrated over the\n"
"                     rectangle, is the bending energy [this]\n"
"      --no-bending   filter H itself\n"
"      --spectrum=FILE  also write a table of the coefficients before filtering to FILE: m, n,\n"
"                     wave number (as --low-pass), |C| of lambda and of lambda H or H in\n"
"                     percent (as -K).  m n = 0 0 is the mean; a conjugate pair has one row.\n"
"                     The input must be one grid\n"
CMD_USAGE
"The mean is never dropped.  In both bases sum |C|^2 = nodes sum f^2.\n"
"Why these defaults: cosines extend a field evenly across the border; exponentials extend it\n"
"periodically, and the jump at the border then needs many waves.  The logarithm treats small\n"
"and large lambda alike and keeps lambda positive.  With lambda H, cells of large and of small\n"
"area on the surface are treated alike.  face_neutral at 257 x 257 nodes, K = 0.5, keeps this\n"
"share of the bending energy (the integral of H^2), and the surface is this far from the\n"
"original, in the mean over the square root of the area:\n"
"  dft of lambda and H              135 %   0.49 %\n"
"  dct of lambda and H              111 %   0.35 %\n"
"  dct of log lambda and H          101 %   0.21 %\n"
"  dct of log lambda and lambda H    76 %   0.13 %\n"
"-v prints how many coefficients of each field were kept.\n";

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
	const double before = scales_waves(g);
	int k;

	memcpy(was, lambda, n*sizeof *was);
	memcpy(was + n, H, n*sizeof *was);
	g->frames = s->n;
	for (k = 0; k < s->n; k++) {
		g->frame = k + 1;
		if (s->n > 1)
			cmd_meta(g, s->option, "%.10g", s->bound[k]);
		scales_apply(s, k, before, in, g);
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
			scales_apply(&s, 0, scales_waves(&g), &in, &g);
			cmd_pass(&in, &g);
			lhg_free(&g);
		}
	return cmd_end();
}
