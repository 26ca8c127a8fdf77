/* gridfit.c - the surface of one grid, by either method. */
#include "../../lib/surface/frame.h"
#include "../shared/chartof.h"
#include "../shared/claim.h"
#include "../shared/range.h"
#include "channels.h"
#include "deviation.h"
#include "framefit.h"
#include "gridfit.h"

/* Memory that each method needs, and that --follow needs in addition, in doubles for each node. */
enum { SURFACE_NUMBERS = 61, FRAME_NUMBERS = 680, FOLLOW_NUMBERS = 3 };

double *
gridfit(const CmdInput *in, Lhg *g, int method, int follows, const SurfaceFit *o)
{
	const double *lambda = cmd_need(in, g, "lambda", LHG_GRID), *H = cmd_need(in, g, "H", LHG_GRID);
	Chart chart = chart_of(g);
	FitProgress at = { 0 };
	double *phi;

	if (method == GRIDFIT_FRAME && chart.kind != &CHART_RECTANGLE)
		die("%s: the frame method is for the rectangle, not for the %s; use --method=surface", in->name,
		    chart.kind->name);
	claim(in->name, method == GRIDFIT_FRAME ? "the frame method" : "the surface method",
		(double)g->nu*g->nv,
	    8*(method == GRIDFIT_FRAME ? FRAME_NUMBERS : SURFACE_NUMBERS + follows*FOLLOW_NUMBERS));
	phi = cmd_alloc(3*(size_t)g->nu*g->nv, sizeof *phi);
	range_height(in, g);
	range_lambda_h(in, g, lambda, H);
	cmd_progress("frame %d of %d, %d x %d nodes", g->frame, g->frames, g->nu, g->nv);
	if (method == GRIDFIT_FRAME) {
		band_read(in, g, FRAME_BAND, phi);
		framefit(in, chart, lambda, H, phi);
	} else {
		band_read(in, g, surfacefit_rings(g, o), phi);
		surfacefit(in, g, o, phi, &at);
	}
	if (!o->no_place)
		deviation(in, g, phi);
	surface_replace(in, g, phi);
	surfacefit_meta(g, &at);
	return phi;
}
