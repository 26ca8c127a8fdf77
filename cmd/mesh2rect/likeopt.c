/* likeopt.c - the options --like and --like-reversed of mesh2rect. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../lib/map/corners.h"
#include "../../lib/morph/curvematch.h"
#include "../../lib/mesh/disk.h"
#include "../../lib/morph/outline.h"
#include "../shared/borderread.h"
#include "../shared/chartof.h"
#include "likeopt.h"

enum { POINTS = 2048 };                 /* on each outline */
static const double CLEAR = 1.25;       /* a fit with more than this times the distance of the best is
                                         * clearly worse */

typedef struct Fit {
	int    shift;
	double rms, next;
} Fit;

static void
outline(const char *name, int n, const double *x, Outline *o)
{
	switch (outline_init(o, POINTS, n, x)) {
	case 0: break;
	case OUTLINE_ENOMEM: die("no memory for the outline of %d vertices", n);
	default: die("%s: the boundary has no length", name);
	}
}

/* Reads the outline of the grid's boundary and the places of the grid's corners on it. */
static void
read_like(const char *path, Outline *o, double corner[4])
{
	CmdInput in;
	Lhg g;
	Border b;
	int k;

	cmd_open(&in, path);
	cmd_read_one(&in, &g);
	if (chart_of(&g).kind->closed)
		die("%s: is on a %s, which has no boundary; --like needs a rectangle, as the mesh is open", in.name,
		    lhg_chartname(g.chart));
	border_read(&in, &g, &b);
	outline(in.name, b.n, b.x, o);
	for (k = 0; k < 4; k++)
		corner[k] = outline_place(o, border_arc(&b, k)/b.s[b.n]);
	border_free(&b);
	lhg_free(&g);
}

static void
loop_outline(const Disk *d, Outline *o)
{
	double *x = cmd_alloc(d->nb, 3*sizeof *x);
	int i;

	for (i = 0; i < d->nb; i++)
		memcpy(x + 3*(size_t)i, d->m.xyz + 3*(size_t)d->loop[i], 3*sizeof *x);
	outline("the mesh", d->nb, x, o);
	free(x);
}

static Fit
fit(const Outline *a, const Outline *b)
{
	double *rms = cmd_alloc(2*POINTS, sizeof *rms), *angle = rms + POINTS;
	Fit f;

	switch (curvematch(POINTS, a->x, b->x, rms, angle)) {
	case 0: break;
	case CURVEMATCH_ENOMEM: die("no memory for the correlation of the boundaries");
	default: die("the boundaries cannot be compared");
	}
	f.shift = curvematch_choose(POINTS, rms, angle, CLEAR);
	f.rms = rms[f.shift];
	f.next = curvematch_next(POINTS, rms, f.shift);
	free(rms);
	return f;
}

/* Reverses d, and replaces its outline b and the fit f, if the outlines are then closer. */
static void
try_reversed(const char *name, const Outline *a, Disk *d, Outline *b, Fit *f)
{
	Outline turned;
	Fit g;

	disk_flip(d);
	loop_outline(d, &turned);
	g = fit(a, &turned);
	detail("%s: boundaries %.3g apart, %.3g with the normal reversed", name, f->rms, g.rms);
	if (g.rms < f->rms) {
		outline_free(b);
		*b = turned;
		*f = g;
	} else {
		outline_free(&turned);
		disk_flip(d);
	}
}

static void
report_fit(const char *name, const Fit *f)
{
	detail("%s: boundaries %.3g of their size apart, %.3g in the next best fit", name, f->rms, f->next);
	if (f->next <= CLEAR*f->rms)
		note("%s: the boundaries fit equally well in two positions (%.3g and %.3g of their size apart): the fit "
		    "that turns the mesh less is chosen", name, f->rms, f->next);
}

double
opt_like(const char *path, int reversed, Disk *d, int corner[4])
{
	Outline a, b;
	double at[4];
	int k;
	Fit f;

	read_like(path, &a, at);
	loop_outline(d, &b);
	f = fit(&a, &b);
	if (reversed)
		try_reversed(cmd_name_of(path), &a, d, &b, &f);
	for (k = 0; k < 4; k++)
		at[k] = fmod(outline_back(&b, fmod(at[k] + (double)f.shift/POINTS, 1)), 1);
	if (corners_at(d, at, corner))
		die("no memory for the boundary");
	report_fit(cmd_name_of(path), &f);
	outline_free(&a);
	outline_free(&b);
	return f.rms;
}
