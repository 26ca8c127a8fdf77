/* lhfft - multi-scale representation: drop small Fourier coefficients of lambda and H */
#include <stdlib.h>
#include <string.h>

#include "shared/cmd.h"
#include "shared/warped.h"
#include "shared/place.h"
#include "lhfft/scales.h"
#include "lhfft/spectable.h"

enum { K_LAMBDA = 256, K_H, BENDING, NO_BENDING, SCALE, RELIEF, PAPER, SPECTABLE = CMD_UNRECORDED };

static const char text[] =
"usage: lhfft --scale=L[,L..] | --relief=TAU[,..] | -K X[,X..] | --keep=N[,..] |\n"
"             --energy=SHARE[,..] | --low-pass=R[,..] [LH] >lh.lhg\n"
"Smooths lambda and H.  Other channels and metadata pass through.  A list of numbers makes a\n"
"stream of the one grid of the input: a grid for each number, with the number in its metadata.\n"
"On the surface, with the channels place.x place.y place.z (positions, which lh2grid then keeps\n"
"to in long waves); L and TAU are lengths in the unit of the mesh, or with % in percent of the\n"
"square root of the area:\n"
"      --scale=L      drop waves shorter than L.  On the surface a wave of length l is\n"
"                     multiplied by 1/(1 + (L/l)^6)\n"
"      --relief=TAU   drop what is lower than TAU, keep what is higher and keep it sharp\n"
"On the rectangle, without place, by the coefficients C of transforms of log lambda and lambda H:\n"
"  -K, --bound=X      drop |C| <= X percent of the field's root mean square, that is\n"
"                     |C|/(nodes rms) 100 <= X; 0 changes nothing\n"
"      --K-lambda=X, --K-H=X  a bound for one field in place of -K; without -K the other is\n"
"                     not changed\n"
"      --raw          compare X with |C| itself\n"
"      --keep=N       keep the N largest of each field, N >= 1\n"
"      --energy=SHARE keep the largest that hold SHARE, 0..1, of sum |C|^2 without the mean\n"
"      --low-pass=R   keep waves of up to R cycles per width of the rectangle\n"
"      --basis=dct|dft  cosines, or the complex exponentials of the paper [dct]\n"
"      --no-log-lambda  filter lambda, not its logarithm; values below the minimum before are\n"
"                     raised to it, and their number is noted [--log-lambda]\n"
"      --no-bending   filter H, not lambda H [--bending]\n"
"      --paper        exactly (32) of the paper: --raw --basis=dft --no-log-lambda --no-bending\n"
"      --spectrum=FILE  also write the coefficients before filtering to FILE: m, n, wave number\n"
"                     (as --low-pass), |C| of both fields in percent (as -K).  m n = 0 0 is the\n"
"                     mean; a conjugate pair has one row.  The input must be one grid\n"
CMD_USAGE
"Which: --scale for a surface at a scale; --relief against noise and texture, where edges must\n"
"stay; -K --paper for the paper's figures; --low-pass, --keep, --energy to study the fields.\n"
"-K leaves ripples and moves the surface 4 to 40 times as far as --scale does for as much\n"
"smoothing (12 meshes).\n"
"The mean is never dropped.  In both bases sum |C|^2 = nodes sum f^2.  Cosines extend a field\n"
"evenly across the border; exponentials extend it periodically, with a jump.  The harmonic\n"
"function with the border values of log lambda is not filtered: it holds the corners, where\n"
"lambda may go to 0.  (lambda H)^2, integrated over the rectangle, is the bending energy.\n"
"The metadatum waves says what is kept, for grid2mesh --detail=smooth; scale is L.\n"
"-v prints how many coefficients of each field were kept.\n"
"Example: lhfft --scale=6 face.lhg | lh2grid | grid2mesh -o smooth.ply\n";

static const struct option longopt[] = {
	{ "scale",         required_argument, NULL, SCALE },
	{ "relief",        required_argument, NULL, RELIEF },
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
	{ "paper",         no_argument,       NULL, PAPER },
	{ "spectrum",      required_argument, NULL, SPECTABLE },
	CMD_LONGOPT
};

enum { FIELDS = 5 };

/* Writes the grid once for each of the s->n scales, as a set. */
static void
write_scales(const CmdInput *in, Lhg *g, const Scales *s)
{
	const char *const name[FIELDS] = { "lambda", "H", PLACE[0], PLACE[1], PLACE[2] };
	size_t n = (size_t)g->nu*g->nv;
	double *was = cmd_alloc(FIELDS*n, sizeof *was);
	const ScalesBefore before = scales_before(g);
	int k, c;

	for (c = 0; c < FIELDS; c++)
		if (lhg_find(g, name[c]))
			memcpy(was + c*n, cmd_need(in, g, name[c], LHG_GRID), n*sizeof *was);
	g->frames = s->n;
	for (k = 0; k < s->n; k++) {
		g->frame = k + 1;
		for (c = 0; c < FIELDS; c++)
			if (lhg_find(g, name[c]))
				memcpy(lhg_find(g, name[c])->f, was + c*n, n*sizeof *was);
		if (s->n > 1 && s->way == SCALES_COEFFICIENTS)
			cmd_meta(g, s->option, "%.10g", s->bound[k]);
		scales_apply(s, k, before, in, g);
		cmd_write(g);
	}
	free(was);
}

static void
say_warped(const CmdInput *in, const Lhg *g)
{
	if (warped_H(g))
		note("%s: %s", in->name, warped_H(g));
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
		case SCALE: scales_set_lengths(&s, SCALES_LENGTH, "scale", optarg); break;
		case RELIEF: scales_set_lengths(&s, SCALES_RELIEF, "relief", optarg); break;
		case PAPER: scales_paper(&s); break;
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
		say_warped(&in, &g);
		scales_need(&in, &g);
		if (table)
			spectable_write(table, &in, &g, &s);
		write_scales(&in, &g, &s);
		lhg_free(&g);
	} else
		while (cmd_read(&in, &g)) {
			say_warped(&in, &g);
			scales_apply(&s, 0, scales_before(&g), &in, &g);
			cmd_pass(&in, &g);
			lhg_free(&g);
		}
	return cmd_end();
}
