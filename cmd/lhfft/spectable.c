/* spectable.c - the table of coefficients that lhfft --spectrum writes. */
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../shared/chartof.h"
#include "../shared/samefile.h"
#include "spectable.h"

void
opt_spectable(const char *file)
{
	const char *out = cmd_output();

	if (strcmp(file, "-") == 0 || (out ? same_file(file, out) : same_as_stream(file, STDOUT_FILENO)))
		misuse("--spectrum=%s: the grid is written there", file);
}

static double *
spectrum_of(Spectrum space, const CmdInput *in, const char *name, const double *f, int logarithm)
{
	double *percent = cmd_alloc(spectrum_size(space), sizeof *percent);

	if (filter_percent(space, logarithm, f, percent))
		die("%s: no memory for the spectrum of %s", in->name, name);
	return percent;
}

void
spectable_write(const char *file, const CmdInput *in, const Lhg *g, const Scales *s)
{
	Spectrum space = { s->basis, chart_of(g) };
	double *f = scales_curvature(s, in, g), *r = scales_ratio(in, g), *H, *lambda;
	int m, n;
	CmdText t;
	size_t q;

	scales_need_basis(s, in, g);
	H = spectrum_of(space, in, scales_name(s), f, 0);
	lambda = spectrum_of(space, in, "lambda", r, s->log);
	cmd_text_open(&t);
	fprintf(t.f, "m\tn\twave\tlambda\t%s\n", scales_name(s));
	for (q = 0; q < spectrum_size(space); q++) {
		spectrum_numbers(space, q, &m, &n);
		fprintf(t.f, "%d\t%d\t%.6g\t%.6g\t%.6g\n", m, n, spectrum_wave(space, q), lambda[q], H[q]);
	}
	cmd_text_close(&t);
	cmd_write_bytes(file, t.bytes, t.n);
	free(t.bytes);
	free(lambda);
	free(H);
	free(f);
	free(r);
}
