/* charts.h - charts with joined sides (lib/base/chart.h), for tests; no program makes TUBE or PILLOW. */
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

/* A closed surface: periodic in v, and the points (-u,-v) and (u,v) are the same. */
static int
pillow_beyond(Chart g, int *i, int *j)
{
	int out = *i < 0 || *i >= g.nu;

	if (out) {
		*i = *i < 0 ? -1 - *i : 2*g.nu - 1 - *i;
		*j = g.nv - 1 - *j;
	}
	*j = wrap(*j, g.nv);
	return out ? -1 : 1;
}

static const ChartKind TUBE = { "tube", .joined = { { 0, 0 }, { 1, 1 } }, .beyond = tube_beyond };
static const ChartKind PILLOW = { "pillow", .joined = { { 1, 1 }, { 1, 1 } }, .beyond = pillow_beyond };
static const ChartKind *const KINDS[4] = { &CHART_RECTANGLE, &TUBE, &PILLOW, &CHART_SOCK };

#endif
