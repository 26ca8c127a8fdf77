/* scales.c - the filter options of lhfft, and their application to a grid. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../shared/chartof.h"
#include "../shared/claim.h"
#include "../shared/cmd.h"
#include "../shared/range.h"
#include "../shared/place.h"
#include "ownmetric.h"
#include "scales.h"

static const double RING = 1.5;         /* steps */
static const char ways[] = "need exactly one of --scale=L, --relief=TAU, -K X, --raw -K X, --keep=N, "
    "--energy=SHARE, --low-pass=R";

void
scales_init(Scales *s)
{
	*s = (Scales){ .lambda = -1, .H = -1, .log = 1, .bending = 1 };
}

void
scales_paper(Scales *s)
{
	s->raw = 1;
	s->basis = SPECTRUM_DFT;
	s->log = s->bending = 0;
}

static double
number(const Scales *s, char *word, int *percent)
{
	size_t n = strlen(word);

	*percent = s->way != SCALES_COEFFICIENTS && n > 0 && word[n-1] == '%';
	if (*percent)
		word[n-1] = '\0';
	if (s->way != SCALES_COEFFICIENTS)
		return opt_double(word, 1e-65, 1e65, s->option);
	switch (s->rule) {
	case FILTER_KEEP:   return opt_long(word, 1, 2147483647, s->option);
	case FILTER_ENERGY: return opt_double(word, 0, 1, s->option);
	default:            return opt_double(word, 0, 1e300, s->option);
	}
}

static void
set(Scales *s, const char *option, const char *list)
{
	char *copy = cmd_alloc(strlen(list) + 1, 1), *word = copy, *comma;

	if (s->option && strcmp(s->option, option) != 0)
		misuse("%s", ways);
	s->option = option;
	strcpy(copy, list);
	for (s->n = 0; word; word = comma) {
		if ((comma = strchr(word, ',')))
			*comma++ = '\0';
		if (s->n == SCALES_MAX)
			misuse("--%s: more than %d scales", option, SCALES_MAX);
		s->bound[s->n] = number(s, word, &s->percent[s->n]);
		s->n++;
	}
	free(copy);
}

void
scales_set(Scales *s, FilterRule rule, const char *option, const char *list)
{
	s->rule = rule;
	set(s, option, list);
}

void
scales_set_lengths(Scales *s, ScalesWay way, const char *option, const char *list)
{
	s->way = way;
	set(s, option, list);
}

void
scales_check(Scales *s)
{
	int apart = s->lambda >= 0 || s->H >= 0, own = s->way != SCALES_COEFFICIENTS;

	if ((!s->option && !apart) || ((apart || s->raw) && (own || s->rule != FILTER_PERCENT)))
		misuse("%s", ways);
	if (own && (s->basis != SPECTRUM_DCT || !s->log || !s->bending))
		misuse("--basis, --no-log-lambda and --no-bending are for filters that drop coefficients");
	if (!s->option)
		s->n = 1;               /* bound 0: a field without its own bound is unchanged */
	if (s->raw)
		s->rule = FILTER_RAW;
}

static double
least(size_t n, const double *f)
{
	double min = f[0];
	size_t p;

	for (p = 1; p < n; p++)
		min = f[p] < min ? f[p] : min;
	return min;
}

/* Raises lambda to `floor` where filtering made it smaller, since lambda must be positive. */
static void
clamp(const CmdInput *in, const Lhg *g, double floor)
{
	double *lambda = cmd_need(in, g, "lambda", LHG_GRID);
	size_t p, count = 0, n = (size_t)g->nu*g->nv;

	for (p = 0; p < n; p++)
		if (lambda[p] < floor) {
			lambda[p] = floor;
			count++;
		}
	if (count)
		note("%s: lambda raised to %g, its minimum before filtering, at %zu of %zu nodes", in->name,
			floor, count, n);
}

/* Filters f.  Returns whether f has changed.  Raises *most to the number of coefficients kept if
 * that is larger. */
static int
filter(const CmdInput *in, const Lhg *g, const char *name, double *f, SpectrumBasis basis,
	Filter by, size_t *most)
{
	size_t kept, n = (size_t)g->nu*g->nv;
	int changed = filter_field((Spectrum){ basis, chart_of(g) }, &by, f, &kept);

	if (changed < 0)
		die("%s: no memory for the transform of %zu nodes", in->name, n);
	detail("%s: %zu of %zu coefficients of %s kept", in->name, kept, n, name);
	*most = kept > *most ? kept : *most;
	return changed;
}

void
scales_need_basis(const Scales *s, const CmdInput *in, const Lhg *g)
{
	if (!spectrum_exists((Spectrum){ s->basis, chart_of(g) }))
		die("%s: a %s is not periodic along v, so it has no exponentials: --basis=dct", in->name,
			lhg_chartname(g->chart));
}

double
scales_need(const CmdInput *in, const Lhg *g)
{
	double floor = least((size_t)g->nu*g->nv, cmd_need(in, g, "lambda", LHG_GRID));

	cmd_need(in, g, "H", LHG_GRID);
	range_height(in, g);
	if (!(floor > 0))
		die("%s: lambda is not positive everywhere", in->name);
	claim(in->name, "the transform", (double)g->nu*g->nv, 8*10);
	range_channel(in, g, "lambda");
	range_channel(in, g, "H");
	return floor;
}

const char *
scales_name(const Scales *s)
{
	return s->bending ? "lambda H" : "H";
}

double *
scales_curvature(const Scales *s, const CmdInput *in, const Lhg *g)
{
	const double *lambda = cmd_need(in, g, "lambda", LHG_GRID), *H = cmd_need(in, g, "H", LHG_GRID);
	size_t n = (size_t)g->nu*g->nv, p;
	double *f = cmd_alloc(n, sizeof *f);

	for (p = 0; p < n; p++)
		f[p] = s->bending ? lambda[p]*H[p] : H[p];
	range_field(in, g, scales_name(s), f);
	return f;
}

void
scales_set_waves(Lhg *g, ScalesBefore before, double waves)
{
	cmd_meta(g, "waves", "%.6g", before.waves > 0 && before.waves < waves ? before.waves : waves);
}

static double
positive(const Lhg *g, const char *key)
{
	char value[LHG_KEYLEN];

	return lhg_getmeta(g, key, value, sizeof value) ? strtod(value, NULL) : 0;
}

ScalesBefore
scales_before(const Lhg *g)
{
	return (ScalesBefore){ positive(g, "waves"), positive(g, "scale") };
}

double *
scales_ratio(const CmdInput *in, const Lhg *g)
{
	size_t n = (size_t)g->nu*g->nv, p;
	double *lambda = cmd_need(in, g, "lambda", LHG_GRID), *ratio = cmd_alloc(n, sizeof *ratio);

	chart_round(chart_of(g), ratio);
	for (p = 0; p < n; p++)
		ratio[p] = lambda[p]/ratio[p];
	return ratio;
}

static int
filter_lambda(const Scales *s, const CmdInput *in, Lhg *g, Filter by, size_t *most)
{
	size_t n = (size_t)g->nu*g->nv, p;
	double *lambda = lhg_find(g, "lambda")->f, *ratio = scales_ratio(in, g), *lambda0;
	int changed = filter(in, g, "lambda", ratio, s->basis, by, most);

	lambda0 = cmd_alloc(n, sizeof *lambda0);
	chart_round(chart_of(g), lambda0);
	for (p = 0; changed && p < n; p++)
		lambda[p] = ratio[p]*lambda0[p];
	free(lambda0);
	free(ratio);
	return changed;
}

/* Beside a cone lambda is small, so the ripples of the filtered lambda H would be large in H.  Within a
 * quarter of the shortest wave, but at least RING steps, H is set to its mean on a ring round that. */
static void
calm_cones(Chart g, double waves, const double *lambda, double *H)
{
	double R = fmax(0.25/waves, RING*chart_h(g)), sum, area, d;
	int p, c, n = g.nu*g.nv;

	for (c = 0; c < g.kind->cones; c++) {
		for (sum = area = 0, p = 0; p < n; p++) {
			d = chart_from_cone(g, c, p);
			if (d >= R && d < R + RING*chart_h(g)) {
				sum += lambda[p]*lambda[p]*H[p];
				area += lambda[p]*lambda[p];
			}
		}
		for (p = 0; p < n && area > 0; p++)
			if (chart_from_cone(g, c, p) < R)
				H[p] = sum/area;
	}
}

/* A field whose coefficients are all kept does not change, not even in its last bits.  The number of
 * waves, in cycles per width, is the radius of the quarter disk of wave numbers that contains as many
 * cosines, pi waves^2 T, as the filter kept.  The place does not belong to the changed lambda and H, so
 * it is removed. */
static void
drop_coefficients(const Scales *s, int k, ScalesBefore before, const CmdInput *in, Lhg *g)
{
	size_t n = (size_t)g->nu*g->nv, p, most = 0;
	int changed;
	double floor = scales_need(in, g), K = s->bound[k], *lambda = lhg_find(g, "lambda")->f;
	double *H = lhg_find(g, "H")->f, *f = scales_curvature(s, in, g);

	scales_need_basis(s, in, g);
	changed = filter_lambda(s, in, g, (Filter){ s->rule, s->lambda >= 0 ? s->lambda : K, s->log }, &most);
	if (!s->log)
		clamp(in, g, floor);
	if (filter(in, g, scales_name(s), f, s->basis, (Filter){ s->rule, s->H >= 0 ? s->H : K, 0 }, &most)) {
		for (p = 0; p < n; p++)
			H[p] = s->bending ? f[p]/lambda[p] : f[p];
		calm_cones(chart_of(g), sqrt((double)most/(M_PI*g->T)), lambda, H);
		changed = 1;
	}
	free(f);
	if (changed || s->n > 1) {
		scales_set_waves(g, before, sqrt((double)most/(M_PI*g->T)));
		place_drop(g);
	}
}

void
scales_apply(const Scales *s, int k, ScalesBefore before, const CmdInput *in, Lhg *g)
{
	if (s->way == SCALES_COEFFICIENTS)
		drop_coefficients(s, k, before, in, g);
	else {
		scales_need(in, g);
		ownmetric_apply(s, k, before, in, g);
	}
}
