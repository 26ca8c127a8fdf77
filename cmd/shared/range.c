/* range.c - input limits within which no stage overflows. */
#include <math.h>

#include "chartof.h"
#include "range.h"

static const double LENGTH = 1e60, RATIO = 1e12, NUMBER = 1e100, FAR = 1e3;

void
range_positions(const char *name, size_t n, int stride, const double *const x[3])
{
	double most = 0, side = 0, lo, hi;
	size_t k;
	int c;

	for (c = 0; c < 3; c++) {
		for (lo = HUGE_VAL, hi = -HUGE_VAL, k = 0; k < n; k++) {
			lo = fmin(lo, x[c][k*stride]);
			hi = fmax(hi, x[c][k*stride]);
		}
		most = fmax(most, fmax(hi, -lo));
		side = fmax(side, hi - lo);
	}
	if (most > LENGTH)
		die("%s: a coordinate of size %.3g, more than %g", name, most, LENGTH);
	if (side > 0 && side < 1/LENGTH)
		die("%s: the surface is %.3g wide, less than %g", name, side, 1/LENGTH);
}

void
range_height(const CmdInput *in, const Lhg *g)
{
	const ChartKind *kind = chart_of(g).kind;

	if (!(g->T >= kind->lowest && g->T <= kind->highest))
		die("%s: the height T is %g, not in [%g,%g]", in->name, g->T, kind->lowest, kind->highest);
}

void
range_lambda_h(const CmdInput *in, const Lhg *g, const double *lambda, const double *H)
{
	size_t n = (size_t)g->nu*g->nv, p;
	double lo = HUGE_VAL, hi = 0;

	for (p = 0; p < n; p++) {
		if (!(lambda[p] > 0))
			die("%s: lambda is %g at node (%zu,%zu), must be positive",
			    in->name, lambda[p], p%g->nu, p/g->nu);
		if (fabs(H[p])*lambda[p] > RATIO)
			die("%s: H lambda is %.3g at node (%zu,%zu), more than %g",
			    in->name, H[p]*lambda[p], p%g->nu, p/g->nu, RATIO);
		lo = fmin(lo, lambda[p]);
		hi = fmax(hi, lambda[p]);
	}
	if (lo < 1/LENGTH || hi > LENGTH || hi > RATIO*lo)
		die("%s: lambda goes from %.3g to %.3g, need [%g,%g] and a ratio of at most %g",
		    in->name, lo, hi, 1/LENGTH, LENGTH, RATIO);
}

void
range_width(const CmdInput *in, const Lhg *g, const char *name)
{
	const LhgChannel *c = lhg_find(g, name), *lambda = lhg_find(g, "lambda");
	double lo = HUGE_VAL, hi = -HUGE_VAL, reach = 0;
	size_t k;

	range_channel(in, g, name);
	for (k = 0; k < c->n; k++) {
		lo = fmin(lo, c->f[k]);
		hi = fmax(hi, c->f[k]);
	}
	for (k = 0; k < lambda->n; k++)
		reach = fmax(reach, lambda->f[k]*(1 + g->T));
	if (hi - lo > FAR*reach)
		die("%s: channel %s is %.3g wide, where lambda allows %.3g", in->name, name, hi - lo, reach);
}

void
range_field(const CmdInput *in, const Lhg *g, const char *what, const double *f)
{
	size_t n = (size_t)g->nu*g->nv, p;

	for (p = 0; p < n; p++)
		if (fabs(f[p]) > NUMBER)
			die("%s: %s is %.3g at node (%zu,%zu), more than %g", in->name, what, f[p],
			    p%g->nu, p/g->nu, NUMBER);
}

void
range_channel(const CmdInput *in, const Lhg *g, const char *name)
{
	const LhgChannel *c = lhg_find(g, name);
	size_t k;

	for (k = 0; c && k < c->n; k++)
		if (fabs(c->f[k]) > NUMBER)
			die("%s: channel %s has a sample of %.3g, more than %g", in->name, name, c->f[k], NUMBER);
}
