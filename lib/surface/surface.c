/* surface.c - the surface method, coarse to fine. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "anchor.h"
#include "bordersmooth.h"
#include "cornersmooth.h"
#include "fitexact.h"
#include "level.h"
#include "start.h"
#include "../base/field.h"
#include "../grid/stencil.h"
#include "surface.h"

static const double ENOUGH = 1e-4;      /* tolerance of coarse grids */
enum { ROUGH = 12, STAGE = 4 }; /* most steps on coarse grids; for a surface between the start and the result */
/* The fit ends when the predicted decrease is below this share of E: on the finest grid, and on coarse
 * ones, where the interpolation to the next grid changes E by far more. */
static const double FLAT = 1e-6, FLAT_COARSE = 1e-3;
static const double WHOLE[2] = { 1, 1 };
/* How far cones of filtered data are held firm (misfit_set_firm), in units of u, and where a place holds a closed
 * surface, too. */
static const double FIRM = 0.05, FIRM_PLACED = 0.025;

static double
firm_reach(const Surface *s, const Residue *residue, const MisfitPlace *place)
{
	if (!s->filtered || residue)
		return 0;
	return !place ? FIRM : s->g.kind->closed ? FIRM_PLACED : 0;
}

static int
fit_level(const Surface *s, const Level *l, int finest, const MisfitPlace *place, const FitOptions *o,
	FitProgress *at)
{
	const Residue *residue = finest ? s->residue : NULL;
	Misfit m;
	int r;

	if (misfit_init(&m, l->g, l->lambda2, l->l2H, residue))
		return SURFACE_ENOMEM;
	if (s->free)
		misfit_set_free(&m);
	if (misfit_hold(&m, place) || misfit_set_firm(&m, firm_reach(s, residue, place))) {
		misfit_free(&m);
		return SURFACE_ENOMEM;
	}
	at->cost *= (size_t)at->nu*at->nv/(double)level_nodes(l->g);
	r = fit(&m, o, l->phi, at);
	at->cost += at->solves;
	if (r > 0 && finest && !residue && corners_smooth(&m, l->phi))
		r = SURFACE_ENOMEM;
	misfit_free(&m);
	return r;
}

/* Fits on the finest grid, whose phi holds the interpolated start. */
static int
fit_finest(const Surface *s, double unit, const Level *l, const MisfitPlace *place, const FitOptions *o,
	FitProgress *at)
{
	size_t n = 3*level_nodes(l->g), p;
	int r;

	if (s->detail)
		memcpy(s->detail, l->phi, n*sizeof *s->detail);
	for (p = 0; s->forecast && p < n; p++)
		l->phi[p] += s->forecast[p]/unit;
	if (s->residue && s->exact && !s->free) {
		at->cost *= (size_t)at->nu*at->nv/(double)level_nodes(l->g);
		r = fitexact(l->g, l->lambda2, l->l2H, s->residue, o, l->phi, at);
	} else
		r = fit_level(s, l, 1, place, o, at);
	if (r > 0 && s->residue && at->misfit > FIT_NEAR && border_smooth(s->g, l->phi))
		r = SURFACE_ENOMEM;
	for (p = 0; s->detail && p < n; p++)
		s->detail[p] = (l->phi[p] - s->detail[p])*unit;
	return r;
}

/* Fits on the finest grid alone: starts from the place, and holds the surface there. */
static int
fit_at_place(const Surface *s, double unit, const Level *l, const FitOptions *o, FitProgress *at)
{
	size_t n = level_nodes(l->g);
	double *phi = malloc(3*n*sizeof *phi);
	MisfitPlace place = { phi, s->place->s/unit };
	FitOptions last = *o;
	Range columns = stencil_apart(l->g, 0, !s->free), rows = stencil_apart(l->g, 1, !s->free);
	int c, i, j, r = SURFACE_ENOMEM;

	last.flat = FLAT;
	if (phi) {
		field_scale(3*n, 1/unit, s->place->phi, phi);
		for (c = 0; c < 3; c++)
			for (j = rows.from; j < rows.to; j++)
				for (i = columns.from; i < columns.to; i++)
					l->phi[c*n + (size_t)j*l->g.nu + i] = phi[c*n + (size_t)j*l->g.nu + i];
		r = fit_finest(s, unit, l, &place, &last, at);
	}
	free(phi);
	return r;
}

/* The start of the coarsest level if none is given. */
static int
find_start(const Surface *s, const Level *l, double *finest)
{
	int e = start_find(s->g, finest, l);

	return e == START_ENONE ? SURFACE_ESTART : e ? SURFACE_ENOMEM : 0;
}

/* Fits the surfaces between the start and that of l, whose phi is the start, in few steps each. */
static int
approach(const Surface *s, const Level *l, const FitOptions *o, FitProgress *at)
{
	size_t n = level_nodes(l->g);
	Level between = { l->g, malloc(n*sizeof(double)), malloc(n*sizeof(double)), l->phi };
	int stages = start_stages(l->g.kind), k, r = between.lambda2 && between.l2H ? 0 : SURFACE_ENOMEM;
	FitOptions few = *o;

	few.tolerance = ENOUGH;
	few.most = STAGE;
	few.sharpen = 0;
	few.settled = 0;
	few.flat = FLAT_COARSE;
	for (k = 1; r >= 0 && k <= stages; k++) {
		if (start_between(l, k/(stages + 1.0), between.lambda2, between.l2H))
			r = SURFACE_ENOMEM;
		else
			r = fit_level(s, &between, 0, NULL, &few, at);
	}
	free(between.lambda2);
	free(between.l2H);
	return r;
}

/* Whether the start has at least as many nodes as g in each direction. */
static int
resolves(const Surface *s, Chart g)
{
	return s->start && s->start_chart.nu >= g.nu && s->start_chart.nv >= g.nv;
}

/* Computes phi of level l, starting from the next coarser level; a held border is given. */
static int
descend(const Surface *s, double unit, const Level *l, const FitOptions *o, double *finest,
	FitProgress *at)
{
	FitOptions coarse = *o, last = *o;
	Level below = { .phi = NULL };
	int r, rings = s->free ? 0 : 1;

	if (s->place)
		return fit_at_place(s, unit, l, o, at);
	if (level_has_coarser(l->g) && !resolves(s, l->g)) {
		r = level_coarsen(l, &below);
		if (!r)
			r = descend(s, unit, &below, o, finest, at);
		if (r >= 0)
			r = level_interpolate(below.g, WHOLE, below.phi, 1, l->g, rings, l->phi);
		level_free(&below);
	} else if (s->start)
		r = level_interpolate(s->start_chart, s->start_end, s->start, 1/unit, l->g, rings, l->phi);
	else {
		r = find_start(s, l, finest);
		if (r >= 0 && start_stages(l->g.kind))
			r = approach(s, l, o, at);
	}
	if (r < 0)
		return r;
	last.flat = FLAT;
	if (l->phi == finest)
		return fit_finest(s, unit, l, NULL, &last, at);
	coarse.tolerance = o->tolerance > ENOUGH ? o->tolerance : ENOUGH;
	coarse.fine = coarse.settled = 0;
	coarse.most = ROUGH;
	coarse.sharpen = 0;
	coarse.flat = s->free ? FLAT : FLAT_COARSE;
	return fit_level(s, l, 0, NULL, &coarse, at);
}

/* Coarsening multiplies interior values by 0; set them to 0 first, since 0*NaN is NaN. */
static void
clear_inside(Chart g, int rings, double *phi)
{
	Range columns = stencil_apart(g, 0, rings), rows = stencil_apart(g, 1, rings);
	int c, i, j;

	for (c = 0; c < 3; c++)
		for (j = rows.from; j < rows.to; j++)
			for (i = columns.from; i < columns.to; i++)
				phi[c*level_nodes(g) + (size_t)j*g.nu + i] = 0;
}

/* The largest power of two not above the mean of lambda: in this unit of length, squares and
 * products are finite. */
static double
unit_of(size_t n, const double *lambda)
{
	double mean = 0;
	size_t p;

	for (p = 0; p < n; p++)
		mean += lambda[p]/n;
	return ldexp(1, ilogb(fmax(mean, 1e-300)));
}

/* Chooses the nodes that fix the rigid position of the result. */
static int
choose_anchor(const Surface *s, double unit, const Level *finest, Anchor *a)
{
	size_t n = 3*level_nodes(s->g);
	double *t;
	int e = 0;

	if (!s->adrift)
		return anchor_init(a, s->g, 1, NULL, finest->phi);
	t = malloc(n*sizeof *t);
	if (!t)
		return SURFACE_ENOMEM;
	if (s->where)
		field_scale(n, 1/unit, s->where, t);
	else
		e = level_interpolate(s->start_chart, s->start_end, s->start, 1/unit, s->g, 0, t);
	if (!e)
		e = anchor_init(a, s->g, 0, s->g.kind->closed ? finest->lambda2 : NULL, t);
	free(t);
	return e;
}

/* Free boundary or none: starts as with a held boundary, fits with all nodes free, then moves the result
 * rigidly into place. */
static int
descend_free(const Surface *s, double unit, const Level *finest, const FitOptions *o, FitProgress *at)
{
	Anchor a = { .n = 0 };
	int r = 0, e = 0;

	if (!s->adrift && !s->g.kind->closed)
		e = choose_anchor(s, unit, finest, &a);
	clear_inside(s->g, s->start ? 0 : start_rings(s->g.kind), finest->phi);
	if (!e)
		r = descend(s, unit, finest, o, finest->phi, at);
	if (!e && r > 0 && s->adrift)
		e = choose_anchor(s, unit, finest, &a);
	if (!e && r > 0 && a.n)
		e = anchor_place(&a, s->g, finest->phi);
	anchor_free(&a);
	return e == ANCHOR_EVALUE ? SURFACE_EPLACE : e ? SURFACE_ENOMEM : r;
}

int
surface(const Surface *s, const FitOptions *o, double *phi, FitProgress *at)
{
	size_t n = level_nodes(s->g), p;
	Level finest = { s->g, malloc(n*sizeof(double)), malloc(n*sizeof(double)), phi };
	double unit = unit_of(n, s->lambda);
	int r = SURFACE_ENOMEM;

	*at = (FitProgress){ .nu = s->g.nu, .nv = s->g.nv };
	if (s->g.nu < 3 || s->g.nv < 3) {
		for (p = 0; s->detail && p < 3*n; p++)
			s->detail[p] = 0;
		r = 1;
	} else if (finest.lambda2 && finest.l2H) {
		for (p = 0; p < n; p++) {
			finest.lambda2[p] = s->lambda[p]/unit*(s->lambda[p]/unit);
			finest.l2H[p] = finest.lambda2[p]*(s->H[p]*unit);
		}
		if (!s->free && !s->g.kind->closed)
			clear_inside(s->g, s->start ? 1 : start_rings(s->g.kind), phi);
		field_scale(3*n, 1/unit, phi, phi);
		r = s->free || s->g.kind->closed ? descend_free(s, unit, &finest, o, at) : descend(s, unit, &finest, o, phi, at);
		field_scale(3*n, unit, phi, phi);
	}
	free(finest.lambda2);
	free(finest.l2H);
	return r;
}
