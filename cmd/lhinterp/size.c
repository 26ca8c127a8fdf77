/* size.c - the area of a surface from lambda; scales a grid to the area of the first. */
#include <math.h>
#include <string.h>

#include "../../lib/base/field.h"
#include "../../lib/grid/stencil.h"
#include "../shared/chartof.h"
#include "size.h"

static const double APART = 2;          /* ratio of sizes above which a note is printed */

/* The square root of the area, which is the integral of lambda^2 du dv, by the trapezoidal rule. */
static double
size_of(const Lhg *g)
{
	const double *lambda = lhg_find(g, "lambda")->f;
	Chart c = chart_of(g);
	Range u = stencil_inner(c, 0), v = stencil_inner(c, 1);
	double sum = 0, l, w;
	int i, j;

	for (j = 0; j < g->nv; j++)
		for (i = 0; i < g->nu; i++) {
			l = lambda[(size_t)j*g->nu + i];
			w = (i < u.from || i >= u.to ? 0.5 : 1)*(j < v.from || j >= v.to ? 0.5 : 1);
			sum += w*l*l;
		}
	return sqrt(sum*chart_h(c)*chart_k(c));
}

/* Multiplies the channels of g with unit length by s, those with unit 1/length by 1/s. */
static void
scale_channels(Lhg *g, double s)
{
	LhgChannel *c;

	for (c = g->chan; c < g->chan + g->nchan; c++)
		if (strcmp(c->unit, "length") == 0)
			field_scale(c->n, s, c->f, c->f);
		else if (strcmp(c->unit, "1/length") == 0)
			field_scale(c->n, 1/s, c->f, c->f);
		else if (strcmp(c->unit, "1") != 0)
			note("channel %s is in %s and is not scaled", c->name, c->unit);
}

void
size_match(const Source *a, Source *b, int scaled)
{
	double s = size_of(&a->g)/size_of(&b->g);
	const char *A = a->in.name, *B = b->in.name;

	if (!scaled) {
		if (!(s <= APART && s >= 1/APART))
			note("%s is %.3g times as large as %s: surfaces between them are poor (--scale brings %s to "
			    "the area of %s)", s > 1 ? A : B, s > 1 ? s : 1/s, s > 1 ? B : A, B, A);
		return;
	}
	detail("%s is multiplied by %.6g", B, s);
	scale_channels(&b->g, s);
	if (b->border.n) {
		field_scale(3*(size_t)b->border.n, s, b->border.x, b->border.x);
		field_scale((size_t)b->border.n + 1, s, b->border.s, b->border.s);
		field_scale(3*(size_t)b->match.n, s, b->match.x[1], b->match.x[1]);
	}
}
