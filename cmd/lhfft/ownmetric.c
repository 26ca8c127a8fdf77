/* ownmetric.c - --scale and --relief: low-pass filters of lambda, H and the place. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../lib/base/corner.h"
#include "../../lib/grid/cornerfold.h"
#include "../../lib/scales/borderpart.h"
#include "../../lib/scales/relief.h"
#include "../shared/chartof.h"
#include "../shared/claim.h"
#include "../shared/place.h"
#include "ownmetric.h"

/* --relief: the finest scale, and the scale for lambda, over sqrt(area).  A wave of wave number 1/s at
 * the finest scale s is 1.6 % of sqrt(area) long, four cells of 257 x 257 nodes. */
static const double FINEST = 0.0025, RELIEF_LAMBDA = 0.005;
static const double LEAST = 1e-4, MOST = 1e4;   /* of L and TAU over sqrt(area) */

enum {
	BORDERED = 4,           /* fields that are filtered less their border parts: log(lambda/lambda0),
	                         * x, y, z */
	FIELDS                  /* and H */
};

typedef struct Own {
	const CmdInput *in;
	Lhg    *g;
	Chart   chart;
	size_t  n;
	double *lambda, *H, *place[3], *lambda0;        /* lambda0: of chart_round */
	int     placed;                 /* there is a place */
	double  root;                   /* sqrt(area) */
	double *less[BORDERED], *part[BORDERED];        /* fields less their border parts; these */
	Lowpass held, free;
} Own;

static _Noreturn void
no_memory(const Own *o)
{
	die("%s: no memory for the filter of %zu nodes", o->in->name, o->n);
}

/* The length X or X% of an option in the unit of the mesh. */
static double
length_of(const Own *o, const Scales *s, int k)
{
	double x = s->percent[k] ? s->bound[k]/100*o->root : s->bound[k];

	if (!(x >= LEAST*o->root && x <= MOST*o->root))
		die("%s: --%s is %.4g, need %g .. %g times the square root of the area, %.4g", o->in->name, s->option,
			x, LEAST, MOST, o->root);
	return x;
}

/* Splits log(lambda/lambda0) and the place into border parts and the rest. */
static void
split(Own *o)
{
	const double *f[BORDERED];
	double *log_lambda = cmd_alloc(2*BORDERED*o->n, sizeof *log_lambda);
	size_t p;
	int c;

	for (c = 0; c < BORDERED; c++) {
		o->less[c] = log_lambda + 2*c*o->n;
		o->part[c] = o->less[c] + o->n;
		f[c] = c ? o->place[c-1] : log_lambda;
	}
	memset(log_lambda, 0, 2*BORDERED*o->n*sizeof *log_lambda);
	for (p = 0; p < o->n; p++)
		log_lambda[p] = log(o->lambda[p]/o->lambda0[p]);
	if (border_part(o->chart, 1, f, o->part) || (o->placed && border_part(o->chart, 3, f + 1, o->part + 1)))
		no_memory(o);
	for (c = 0; c < BORDERED && (c == 0 || o->placed); c++)
		for (p = 0; p < o->n; p++)
			o->less[c][p] = f[c][p] - o->part[c][p];
}

static void
join(Own *o)
{
	size_t p;
	int c;

	for (p = 0; p < o->n; p++)
		o->lambda[p] = exp(o->part[0][p] + o->less[0][p])*o->lambda0[p];
	for (c = 1; c < BORDERED && o->placed; c++)
		for (p = 0; p < o->n; p++)
			o->place[c-1][p] = o->part[c][p] + o->less[c][p];
	free(o->less[0]);
}

/* Whether the place, the sum of less and part, is folded within `radius` cells of corner k. */
static int
folds(const Own *o, int k, int radius)
{
	double *x = cmd_alloc(3*o->n, sizeof *x);
	const double *const phi[3] = { x, x + o->n, x + 2*o->n };
	size_t p;
	int c, is;

	for (c = 0; c < 3; c++)
		for (p = 0; p < o->n; p++)
			x[c*o->n+p] = o->less[c+1][p] + o->part[c+1][p];
	is = corner_folds(o->chart, k, phi, radius);
	free(x);
	return is;
}

/* Blends the fields within `radius` cells of corner k into those before the filter, before[FIELDS][n]. */
static void
keep(Own *o, int k, int radius, const double *before)
{
	double *f[FIELDS] = { o->less[0], o->less[1], o->less[2], o->less[3], o->H }, share;
	int a, b, c, p;

	for (b = 0; b < radius; b++)
		for (a = 0; a < radius; a++) {
			p = corner_node(o->chart, k, a, b);
			share = corner_share_within(o->chart, radius, p%o->chart.nu, p/o->chart.nu);
			for (c = 0; c < FIELDS; c++)
				f[c][p] += share*(before[c*o->n+p] - f[c][p]);
		}
}

static double *
copy_fields(const Own *o)
{
	double *before = cmd_alloc(FIELDS*o->n, sizeof *before);
	int c;

	for (c = 0; c < FIELDS; c++)
		memcpy(before + c*o->n, c < BORDERED ? o->less[c] : o->H, o->n*sizeof *before);
	return before;
}

static void
put_fields(Own *o, const double *from)
{
	double *f[FIELDS] = { o->less[0], o->less[1], o->less[2], o->less[3], o->H };
	int c;

	for (c = 0; c < FIELDS; c++)
		memcpy(f[c], from + c*o->n, o->n*sizeof *from);
}

/* Keeps the corners at which the filtered place is folded: where lambda goes to 0 at a corner, a filter leaves only
 * the harmonic function with the border values there, and that may fold, where the border is ragged or the corner
 * reentrant.  If folds remain, at a scale that leaves hardly more than that function anywhere, more is kept, up to half
 * of the shorter side, but no more than at first if that does not help. */
static void
keep_corners(Own *o, const double *before)
{
	const int least = corner_radius(o->chart), half = (o->chart.nu < o->chart.nv ? o->chart.nu : o->chart.nv)/2;
	double *first;
	int k, radius;

	for (k = 0; k < 4 && o->placed; k++) {
		if (!corner_exists(o->chart, k) || !folds(o, k, least))
			continue;
		keep(o, k, least, before);
		first = copy_fields(o);
		for (radius = least; folds(o, k, radius) && radius < half; ) {
			radius = radius + (radius + 1)/2 < half ? radius + (radius + 1)/2 : half;
			keep(o, k, radius, before);
		}
		if (folds(o, k, radius))
			put_fields(o, first);
		free(first);
	}
}

static void
filter(Own *o, const Scales *s, int k, double *L)
{
	const double x = length_of(o, s, k);
	double *before = copy_fields(o);
	int c;

	*L = s->way == SCALES_RELIEF ? 2*M_PI*RELIEF_LAMBDA*o->root : x;
	lowpass(&o->held, *L/(2*M_PI), o->less[0]);
	if (s->way == SCALES_RELIEF) {
		if (relief(&o->free, &o->held, FINEST*o->root, x, o->H, o->less + 1))
			no_memory(o);
	} else {
		lowpass(&o->free, *L/(2*M_PI), o->H);
		for (c = 1; c < BORDERED && o->placed; c++)
			lowpass(&o->held, *L/(2*M_PI), o->less[c]);
	}
	keep_corners(o, before);
	free(before);
}

/* There are as many waves longer than L on the surface as waves of up to lambda/L cycles on the
 * rectangle, with lambda the root mean square. */
static void
set_metadata(const Own *o, const Scales *s, int k, ScalesBefore before, double L)
{
	scales_set_waves(o->g, before, o->root/sqrt(o->g->T)/L);
	cmd_meta(o->g, "scale", "%.10g", fmax(L, before.scale));
	if (s->way == SCALES_RELIEF)
		cmd_meta(o->g, "relief", "%.10g", length_of(o, s, k));
}

void
ownmetric_apply(const Scales *s, int k, ScalesBefore before, const CmdInput *in, Lhg *g)
{
	Own o = { .in = in, .g = g, .chart = chart_of(g), .n = (size_t)g->nu*g->nv,
	    .lambda = lhg_find(g, "lambda")->f, .H = lhg_find(g, "H")->f };
	double L;

	if (g->nu < 3 || g->nv < 3)
		die("%s: %d x %d nodes, --%s needs at least 3 x 3", in->name, g->nu, g->nv, s->option);
	claim(in->name, "the filter", (double)o.n, 8*(s->way == SCALES_RELIEF ? 60 : 47));
	o.lambda0 = cmd_alloc(o.n, sizeof *o.lambda0);
	chart_round(o.chart, o.lambda0);
	o.placed = place_of(in, g, o.place);
	if (s->way == SCALES_RELIEF && !o.placed)
		cmd_need(in, g, PLACE[0], LHG_GRID);
	if (!o.placed)
		note("%s: no channels place.x place.y place.z (grid2lh writes them): the surface will move farther than "
		    "it need", in->name);
	if (lowpass_init(&o.held, o.chart, 1, o.lambda) || lowpass_init(&o.free, o.chart, 0, o.lambda))
		no_memory(&o);
	o.root = lowpass_root_area(&o.free);
	split(&o);
	filter(&o, s, k, &L);
	join(&o);
	set_metadata(&o, s, k, before, L);
	lowpass_free(&o.held);
	lowpass_free(&o.free);
	free(o.lambda0);
}
