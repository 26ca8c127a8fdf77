/* chartof.h - the chart of a grid. */
#ifndef CHARTOF_H
#define CHARTOF_H

#include "../../format/lhg.h"
#include "../../lib/base/chart.h"

static inline Chart
chart_of(const Lhg *g)
{
	return (Chart){ g->nu, g->nv, g->T, chart_kind(lhg_chartname(g->chart)) };
}

#endif
