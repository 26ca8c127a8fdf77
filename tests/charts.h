/* charts.h - charts with joined sides (lib/base/chart.h), for tests; no program makes TUBE. */
#ifndef CHARTS_H
#define CHARTS_H

#include "../lib/base/chart.h"

static inline int
wrap(int i, int n)
{
	return (i%n + n)%n;
}

/* A tube: periodic in v, with boundaries at both ends of u. */
static int
tube_beyond(Chart g, int *i, int *j)
{
	(void)i;
	*j = wrap(*j, g.nv);
	return 1;
}

static const ChartKind TUBE = { "tube", .joined = { { 0, 0 }, { 1, 1 } }, .beyond = tube_beyond };
static const ChartKind *const KINDS[4] = { &CHART_RECTANGLE, &TUBE, &CHART_PILLOW, &CHART_SOCK };

#endif
