/* surfacefit.c - lh2grid's surface method. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "../../lib/grid/resample.h"
#include "../../lib/surface/level.h"
#include "../../lib/surface/start.h"
#include "../../lib/surface/surface.h"
#include "../shared/chartof.h"
#include "../shared/exact.h"
#include "../shared/place.h"
#include "../shared/range.h"
#include "surfacefit.h"

/* With residual channels an exact fit may exist, to which the last steps converge fast.  The tolerance is
 * multiplied by this; where the channels may be those of no surface, only once the misfit is near 0. */
static const double EXACT = 1e-4;

/* Creeping steps go on while the sum of the changes of the last ten, over sqrt(area), is above this: UNSETTLED times
 * the tolerance (or times USUAL, if that is larger), so that the mean step is longer than one that counts as
 * converged.  With a free boundary surfaces bend at hardly any cost, and the bound is UNSETTLED_FREE. */
static const double UNSETTLED = 10, UNSETTLED_FREE = 0.01, USUAL = SURFACEFIT_TOLERANCE;

enum { LATTICE = 32 };          /* steps of a lattice along its shorter side, as grid2lh writes it */

static const char *const START[3] = { "start.x", "start.y", "start.z" };
static const char *const RESIDUE[4] = { "nu1", "nu2", "tau1", "tau2" };

static int
has_start(const Lhg *g, const SurfaceFit *o)
{
	return !o->no_start && lhg_find(g, START[0]);
}

/* Whether the place takes part in E: only if lhfft --scale or --relief has filtered it.  An unfiltered
 * place is the answer itself, so it is used as a start only. */
static int
has_place(const Lhg *g, const SurfaceFit *o)
{
	char value[LHG_KEYLEN];

	return !o->no_place && lhg_find(g, PLACE[0]) && lhg_getmeta(g, "scale", value, sizeof value);
}

static int
starts_at_place(const Lhg *g, const SurfaceFit *o)
{
	return !o->no_place && !o->follows && lhg_find(g, PLACE[0]) && has_start(g, o) && !has_place(g, o);
}

/* The place channels as [3][nv][nu], to be freed. */
static double *
copy_place(const CmdInput *in, const Lhg *g)
{
	size_t n = (size_t)g->nu*g->nv;
	double *phi = cmd_alloc(3*n, sizeof *phi), *f[3];
	int c;

	place_of(in, g, f);
	for (c = 0; c < 3; c++)
		memcpy(phi + c*n, f[c], n*sizeof *phi);
	return phi;
}

/* The place channels as three fields, to be freed, or NULL.  Sets place->s from the metadatum scale. */
static double *
read_place(const CmdInput *in, const Lhg *g, const SurfaceFit *o, MisfitPlace *place)
{
	char value[LHG_KEYLEN], *end;
	double *phi, L;

	if (!has_place(g, o))
		return NULL;
	lhg_getmeta(g, "scale", value, sizeof value);
	L = strtod(value, &end);
	if (*end || !(L > 0 && isfinite(L)))
		die("%s: the metadatum scale is '%s', not a positive number", in->name, value);
	phi = copy_place(in, g);
	*place = (MisfitPlace){ phi, L/(2*M_PI) };
	return phi;
}

static int
has_band(const Lhg *g)
{
	return lhg_find(g, "band.x") || lhg_find(g, "band.y") || lhg_find(g, "band.z");
}

int
surfacefit_rings(const Lhg *g, const SurfaceFit *o)
{
	if (chart_of(g).kind->closed)
		return 0;
	if (!has_start(g, o))
		return has_place(g, o) ? 1 : start_rings(chart_of(g).kind);
	return o->free && !has_band(g) ? 0 : 1;
}

/* The three channels start.x start.y start.z, one after the other, to be freed. */
static double *
copy_start(const CmdInput *in, const Lhg *g, int support)
{
	double *start = NULL;
	size_t n = 0;
	int c;

	for (c = 0; c < 3; c++) {
		cmd_need(in, g, START[c], support);
		range_width(in, g, START[c]);
	}
	for (c = 0; c < 3; c++) {
		const LhgChannel *from = lhg_find(g, START[c]);

		if (from->step != lhg_find(g, START[0])->step)
			die("%s: %s and %s are lattices of different steps", in->name, START[0], START[c]);
		n = from->n;
		start = start ? start : cmd_alloc(3*n, sizeof *start);
		memcpy(start + c*n, from->f, n*sizeof *start);
	}
	return start;
}

/* Where the chart has no lattices the start has all nodes.  Returns as many of them as a lattice has. */
static double *
thin(const CmdInput *in, const double *full, Surface *s)
{
	Chart few = level_thinned(s->g, LATTICE);
	double *start = cmd_alloc(3*level_nodes(few), sizeof *start);
	int c;

	s->start_chart = few;
	s->start_end[0] = s->start_end[1] = 1;
	for (c = 0; c < 3; c++)
		if (resample_cubic(s->g, s->start_end, full + c*level_nodes(s->g), few, start + c*level_nodes(few)))
			die("%s: no memory for a start of %d x %d nodes", in->name, few.nu, few.nv);
	return start;
}

/* Returns the channels start.x start.y start.z as three fields, to be freed.  Sets start, its chart, and
 * where a lattice ends in the rectangle, in s.  *full is set to the fields on all nodes, to be freed, or to NULL. */
static double *
read_start(const CmdInput *in, const Lhg *g, Surface *s, double **full)
{
	int lattices = lhg_count(g, LHG_LATTICE, 1) > 0, step;
	double *start = copy_start(in, g, lattices ? LHG_LATTICE : LHG_GRID);

	if (lattices) {
		step = lhg_find(g, START[0])->step;
		s->start_chart = (Chart){ (g->nu - 1)/step + 1, (g->nv - 1)/step + 1, g->T, s->g.kind };
		s->start_end[0] = (double)((g->nu - 1)/step*step)/(g->nu - 1);
		s->start_end[1] = (double)((g->nv - 1)/step*step)/(g->nv - 1);
	} else {
		*full = start;
		start = thin(in, *full, s);
	}
	if (s->start_chart.nu < 2 || s->start_chart.nv < 2)
		die("%s: the start has %d x %d nodes, need at least 2 x 2", in->name, s->start_chart.nu,
			s->start_chart.nv);
	s->start = start;
	return start;
}

/* Takes the place as the start.  Returns it, to be freed. */
static double *
start_at_place(const CmdInput *in, const Lhg *g, Surface *s)
{
	double *start = copy_place(in, g);

	s->start_chart = s->g;
	s->start_end[0] = s->start_end[1] = 1;
	s->start = start;
	return start;
}

static int
read_residue(const CmdInput *in, const Lhg *g, const SurfaceFit *o, Residue *r)
{
	int i, count = 0;

	for (i = 0; i < 4; i++)
		count += lhg_find(g, RESIDUE[i]) != NULL;
	if (!count || o->ideal)
		return 0;
	for (i = 0; i < 2; i++) {
		r->nu[i] = cmd_need(in, g, RESIDUE[i], LHG_GRID);
		r->tau[i] = cmd_need(in, g, RESIDUE[2+i], LHG_GRID);
		range_channel(in, g, RESIDUE[i]);
		range_channel(in, g, RESIDUE[2+i]);
	}
	return 1;
}

static void
report_step(void *ctx, const FitProgress *at)
{
	const CmdInput *in = ctx;

	cmd_progress("%d x %d nodes, step %d: energy %.4g, change %.1e", at->nu, at->nv, at->step,
	    at->energy, at->change);
	detail("%s: %d x %d nodes, step %d: energy %.6g, change %.2e, %ld solves", in->name,
	    at->nu, at->nv, at->step, at->energy, at->change, at->solves);
}

static double
seconds(void)
{
	struct timespec t;

	clock_gettime(CLOCK_MONOTONIC, &t);
	return t.tv_sec + 1e-9*t.tv_nsec;
}

static void
say_crept(const CmdInput *in, const FitProgress *at)
{
	if (at->stopped == FIT_CREPT)
		note("%s: the last steps crept: energy %.4g, moved by %.1e of sqrt(area) (metadatum stopped)", in->name,
		    at->energy, at->crept);
}

void
surfacefit_meta(Lhg *g, const FitProgress *at)
{
	if (!at->stopped)
		return;         /* no node to compute */
	cmd_meta(g, "misfit", "%.4g", at->misfit);
	cmd_meta(g, "change", "%.2g", at->change);
	cmd_meta(g, "stopped", "%s", at->stopped == FIT_CREPT ? "crept" : "converged");
}

void
surfacefit(const CmdInput *in, const Lhg *g, const SurfaceFit *o, double *phi, FitProgress *at)
{
	Surface s = { .g = chart_of(g), .lambda = lhg_find(g, "lambda")->f, .H = lhg_find(g, "H")->f };
	FitOptions how = { .tolerance = o->tolerance, .most = o->steps, .sharpen = 1, .report = report_step,
	    .ctx = (void *)in };
	double began = seconds();
	char value[LHG_KEYLEN];
	double *full = NULL, *start = has_start(g, o) ? read_start(in, g, &s, &full) : NULL;
	MisfitPlace place;
	double *held = read_place(in, g, o, &place);
	Residue residue = { .truncation = 1 };

	if (starts_at_place(g, o)) {
		free(start);
		start = start_at_place(in, g, &s);
	}
	s.place = held ? &place : NULL;
	s.forecast = o->forecast;
	s.detail = o->detail;
	s.filtered = lhg_getmeta(g, "waves", value, sizeof value) != NULL;
	s.free = o->free && !s.g.kind->closed;
	s.adrift = s.g.kind->closed ? s.start && !s.place : s.free && !surfacefit_rings(g, o);
	how.settled = s.free ? UNSETTLED_FREE : UNSETTLED*fmax(o->tolerance, USUAL);
	s.where = s.g.kind->closed ? o->where ? o->where : full : NULL;
	if (s.free && lhg_getmeta(g, "boundary", value, sizeof value) && strcmp(value, "held") == 0)
		note("%s: lambda follows the length of the boundary: for a free one, lhinterp --boundary=free", in->name);
	if (s.free && (g->nu < 3 || g->nv < 3))
		die("%s: %d x %d nodes, a free boundary needs at least 3 x 3", in->name, g->nu, g->nv);
	if (read_residue(in, g, o, &residue)) {
		s.residue = &residue;
		s.exact = exact_holds(g);
		if (s.exact)
			how.tolerance = EXACT*fmin(o->tolerance, USUAL);
		else
			how.fine = EXACT*o->tolerance;
	}
	switch (surface(&s, &how, phi, at)) {
	case 1:
		if (s.exact && !s.free && at->stopped && !(at->misfit <= FIT_EXACT))
			die("%s: the fit ends at another surface than the one of the residual channels: misfit %.2g, not 0; "
			    "try other cells, or --ideal", in->name, at->misfit);
		say_crept(in, at);
		break;
	case 0:
		die("%s: no convergence in %d steps: energy %.4g, change %.2g, the largest residual at node (%d,%d); "
		    "try fewer cells, or a stronger filter", in->name, at->step, at->energy, at->change,
		    (int)(at->worst%g->nu), (int)(at->worst/g->nu));
	case SURFACE_ESTART: die("%s: no start, and none is found from the band", in->name);
	case SURFACE_EPLACE: die("%s: the %s is too large to place the surface by it", in->name,
		s.adrift ? "start" : "band");
	default: die("%s: no memory for the surface of %d x %d nodes", in->name, g->nu, g->nv);
	}
	detail("%s: %.1f vector Poisson solves of %d x %d nodes, %.2f s", in->name, at->cost, g->nu, g->nv,
	    seconds() - began);
	free(start);
	free(full);
	free(held);
}
