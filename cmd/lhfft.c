/* lhfft - multi-scale representation: drop small Fourier coefficients of lambda and H */
#include <stdlib.h>

#include "../lib/spectrum.h"
#include "cmd.h"

static const char text[] =
"usage: lhfft -K PERCENT | --raw -K BOUND | --keep=N [LH] >lh.lhg\n"
"reads and writes channels lambda H; all else passes through\n"
"  -K, --bound=X      drop the coefficients C of the discrete Fourier transform with\n"
"                     |C| <= X percent of the field's root mean square, that is with\n"
"                     |C|/(nodes rms) 100 <= X; 0 changes nothing; X >= 0\n"
"      --raw          X is compared with |C| itself, as equation (32) is written\n"
"      --keep=N       keep the N largest coefficients of either field instead, N >= 1\n"
CMD_USAGE
"The mean is never dropped.  A node where the filtered lambda falls below the least\n"
"lambda of the input is set to it, and the number of such nodes noted.  Under -v: how\n"
"many coefficients of either field were kept.\n";

static const struct option longopt[] = {
	{ "bound", required_argument, NULL, 'K' },
	{ "raw",   no_argument,       NULL, 'r' },
	{ "keep",  required_argument, NULL, 'k' },
	CMD_LONGOPT
};

static double
least(size_t n, const double *f)
{
	double min = f[0];
	size_t p;

	for (p = 1; p < n; p++)
		min = f[p] < min ? f[p] : min;
	return min;
}

/* lambda is a length: it must not come out of the filter negative. */
static void
clamp(const CmdInput *in, size_t n, double *lambda, double floor)
{
	size_t p, count = 0;

	for (p = 0; p < n; p++)
		if (lambda[p] < floor) {
			lambda[p] = floor;
			count++;
		}
	if (count)
		note("%s: lambda raised to %g, its least before, at %zu of %zu nodes", in->name, floor, count, n);
}

static void
filter(const CmdInput *in, Lhg *g, const char *name, SpectrumRule rule, double bound)
{
	double *f = cmd_need(in, g, name, LHG_GRID);
	size_t kept, n = (size_t)g->nu*g->nv;

	if (spectrum_filter(g->nu, g->nv, f, rule, bound, &kept))
		die("%s: no memory for the transform of %zu nodes", in->name, n);
	detail("%s: %zu of %zu coefficients of %s kept", in->name, kept, n, name);
}

int
main(int argc, char *argv[])
{
	SpectrumRule rule = SPECTRUM_PERCENT;
	double bound = -1, keep = -1, floor, *lambda;
	CmdInput in;
	size_t n;
	int opt;
	Lhg g;

	cmd_begin("lhfft", text);
	while ((opt = cmd_getopt(argc, argv, "K:", longopt)) != -1)
		switch (opt) {
		case 'K': bound = opt_double(optarg, 0, 1e300, "bound"); break;
		case 'r': rule = SPECTRUM_RAW; break;
		case 'k': keep = opt_long(optarg, 1, 2147483647, "keep"); break;
		}
	cmd_operands(argc, argv, 0, 1);
	if ((bound < 0) == (keep < 0) || (keep > 0 && rule == SPECTRUM_RAW))
		misuse("say one of -K X, --raw -K X, --keep=N");
	if (keep > 0)
		rule = SPECTRUM_KEEP;
	cmd_binary_output();

	cmd_open(&in, argv[optind]);
	while (cmd_read(&in, &g)) {
		n = (size_t)g.nu*g.nv;
		lambda = cmd_need(&in, &g, "lambda", LHG_GRID);
		floor = least(n, lambda);
		if (!(floor > 0))
			die("%s: lambda is not positive everywhere", in.name);
		filter(&in, &g, "lambda", rule, keep > 0 ? keep : bound);
		filter(&in, &g, "H", rule, keep > 0 ? keep : bound);
		clamp(&in, n, lambda, floor);
		cmd_write(&g);
		lhg_free(&g);
	}
	return cmd_end();
}
