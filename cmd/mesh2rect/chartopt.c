/* chartopt.c - the chart and the size of the grid. */
#include <stdlib.h>
#include <string.h>

#include "../shared/cmd.h"
#include "chartopt.h"
#include "likesock.h"

static const double KEEP = 0.99;        /* fraction of the area, for -n auto */

void
opt_cells(char *s, Chart *g, ConformalOptions *o)
{
	char *x = strchr(s, 'x'), *first;

	o->keep = strcmp(s, "auto") == 0 ? KEEP : 0;
	o->shape = !x;
	if (o->keep > 0)
		return;
	first = strdup(s);
	if (!first)
		die("no memory");
	if (x)
		first[x - s] = '\0';
	g->nu = 1 + opt_long(first, 4, LHG_MAXN - 1, "cells");
	g->nv = x ? 1 + opt_long(x + 1, 4, LHG_MAXN - 1, "cells") : g->nu;
	free(first);
}

/* The grid of a closed surface. */
static Chart
on_pillow(const ChartOptions *given, Chart g, ConformalOptions *o)
{
	g.kind = &CHART_PILLOW;
	o->choose = 0;
	if (given->corners)
		misuse("--corners: a closed surface has no boundary, hence no corners");
	if (given->reversed)
		misuse("--like-reversed: a closed surface has its normal outside");
	if (given->like) {
		o->keep = o->shape = 0;
		return g;               /* likepillow.h sets its size */
	}
	if (o->shape || o->keep > 0)
		return g;
	g.nu--, g.nv--;                 /* no row or column of nodes lies on a side */
	if (g.nu%2 || g.nu < 8 || g.nv < 6)
		misuse("--cells=%dx%d: a pillow needs an even number of cells round it, at least 8, and at least 6 along",
		    g.nu, g.nv);
	return g;
}

/* The grid of a surface with boundary. */
static Chart
on_open(const ChartOptions *given, Chart g, ConformalOptions *o)
{
	int kind = given->kind;

	g.kind = kind == LHG_SOCK ? &CHART_SOCK : &CHART_RECTANGLE;
	o->choose = kind == CHARTOPT_AUTO;
	if (given->cones && kind != LHG_SOCK)
		misuse("--cones needs --chart=sock, or a closed surface");
	if (given->like && kind == LHG_SOCK) {
		likesock_size(given->like, &g);
		o->keep = o->shape = 0;
		return g;
	}
	if (o->choose && !(o->shape || o->keep > 0))
		misuse("--chart=auto chooses the shape of the grid: --cells=N or auto");
	if (kind != LHG_SOCK || o->shape || o->keep > 0)
		return g;
	g.nu--, g.nv--;                 /* a row of nodes round the sock has as many nodes as cells */
	if (g.nu%2 || g.nu < 8 || g.nv < 6)
		misuse("--cells=%dx%d: a sock needs an even number of cells round it, at least 8, and at least 6 along",
		    g.nu, g.nv);
	return g;
}

/* Dies if the chart of --chart is not for a closed surface, or only for one. */
static void
check_closed(const char *name, const Disk *d, int kind)
{
	if (d->nb > 0 && kind == LHG_PILLOW)
		die("%s: the surface has a boundary, --chart=pillow is for closed surfaces: --chart=sock or rectangle, or "
		    "mesh2disk --holes=all closes it", name);
	if (d->nb == 0 && (kind == LHG_RECTANGLE || kind == LHG_SOCK))
		die("%s: closed surface: no boundary, which --chart=%s needs; mesh2disk --open=auto cuts it open, "
		    "--chart=pillow maps it as it is", name, lhg_chartname(kind));
}

static void
check_like(const ChartOptions *o)
{
	if (o->like && o->corners)
		misuse("--corners and --like exclude each other");
	if (o->reversed && (!o->like || o->kind == LHG_SOCK || o->kind == LHG_PILLOW))
		misuse("--like-reversed needs --like, and a rectangle");
}

Chart
chartopt_before(const ChartOptions *given, Chart g, ConformalOptions *o)
{
	check_like(given);
	if (given->kind == CHARTOPT_UNSET)
		return g;
	return given->kind == LHG_PILLOW ? on_pillow(given, g, o) : on_open(given, g, o);
}

Chart
chartopt_of(const char *name, const Disk *d, const ChartOptions *given, Chart g, ConformalOptions *o)
{
	check_closed(name, d, given->kind);
	if (d->nb == 0)
		return g.kind->closed ? g : on_pillow(given, g, o);
	return given->kind == CHARTOPT_UNSET ? on_open(given, g, o) : g;
}
