/* follow.c - each frame starts from a coarse lattice of the surface of the previous frame.
 *
 * A lattice this coarse only selects one of the surfaces with this lambda and H.  Finer detail of
 * the previous frame, which may be wrong, is not passed on.  On a chart without lattices all nodes are
 * written, and read as if they were a lattice.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../shared/chartof.h"
#include "../shared/range.h"
#include "follow.h"

static const char *const START[3] = { "start.x", "start.y", "start.z" };
enum { LATTICE = 32 };          /* least number of lattice steps along the shorter side */

/* The start of g, to be freed, if its surface is closed and has one.  Dies if it is too wide (range.h). */
static double *
own_start(const CmdInput *in, const Lhg *g)
{
	size_t n = (size_t)g->nu*g->nv;
	double *x;
	int c;

	for (c = 0; c < 3; c++)
		if (!chart_of(g).kind->closed || !lhg_find(g, START[c]) || lhg_find(g, START[c])->support != LHG_GRID)
			return NULL;
	cmd_need(in, g, "lambda", LHG_GRID);
	x = cmd_alloc(3*n, sizeof *x);
	for (c = 0; c < 3; c++) {
		range_width(in, g, START[c]);
		memcpy(x + c*n, lhg_find(g, START[c])->f, n*sizeof *x);
	}
	return x;
}

void
follow_start(Before *before, const CmdInput *in, Lhg *g)
{
	int cells = (g->nu < g->nv ? g->nu : g->nv) - 1, step = cells > LATTICE ? cells/LATTICE : 1, c;
	int support = lhg_count(g, LHG_LATTICE, 1) ? LHG_LATTICE : LHG_GRID;
	const LhgChannel *like = lhg_find(g, START[0]);
	char unit[LHG_NAMELEN];

	if (!before->phi || before->nu != g->nu || before->nv != g->nv || before->chart != g->chart)
		return;
	if (!like)
		like = lhg_find(g, "band.x");
	if (!like)
		return;
	before->own = own_start(in, g);
	snprintf(unit, sizeof unit, "%s", like->unit);
	for (c = 0; c < 3; c++) {
		lhg_drop(g, START[c]);
		cmd_add(g, START[c], unit, support, support == LHG_LATTICE ? step : 0);
		lhg_gather(g, lhg_find(g, START[c]), before->phi + (size_t)c*g->nu*g->nv);
	}
}

void
follow_keep(Before *before, const Lhg *g, double *phi)
{
	follow_end(before);
	*before = (Before){ g->nu, g->nv, g->chart, phi, NULL };
}

void
follow_end(Before *before)
{
	free(before->phi);
	free(before->own);
	*before = (Before){ 0 };
}
