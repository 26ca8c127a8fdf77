/* synth.c - the kinds of surfaces by name, their parameters and domains. */
#include <math.h>
#include <string.h>

#include "synth_shapes.h"

const SynthKind *
synth_kind(int i)
{
	const SynthKind *const tables[] = { synth_shapes, synth_strips, synth_reliefs, synth_closed };
	const SynthKind *k;
	size_t t;

	for (t = 0; t < sizeof tables/sizeof *tables; t++)
		for (k = tables[t]; k->name; k++)
			if (i-- == 0)
				return k;
	return NULL;
}

int
synth_init(Synth *s, const char *name)
{
	int i, k;

	for (k = 0; (s->kind = synth_kind(k)); k++)
		if (!strcmp(s->kind->name, name))
			break;
	if (!s->kind)
		return -1;
	for (i = 0; i < SYNTH_MAXPAR; i++)
		s->p[i] = s->kind->par[i].value;
	return 0;
}

int
synth_set(Synth *s, const char *par, double value)
{
	const SynthPar *q;
	int i;

	for (i = 0; s->kind->par[i].name; i++) {
		q = &s->kind->par[i];
		if (strcmp(q->name, par))
			continue;
		if (!(value >= q->lo && value <= q->hi))
			return SYNTH_ERANGE;
		s->p[i] = value;
		return 0;
	}
	return SYNTH_EPAR;
}

/* T = 1 is known by symmetry for the circle, not for other ovals.  The reflection of the L in
 * its diagonal fixes corners 0 and 2 and exchanges 1 and 3, and with them sides 01 and 03, so
 * T = 1/T = 1. */
int
synth_domain(const Synth *s, SynthDomain *d)
{
	double w, h;

	memset(d, 0, sizeof *d);
	s->kind->domain(s->p, d);
	w = d->x1 - d->x0;
	h = d->y1 - d->y0;
	if (!(w > 0 && h > 0))
		return SYNTH_EDOMAIN;
	d->T = !s->kind->lambda || d->shape == SYNTH_SPHERE ? 0 : d->shape == SYNTH_RECT ? h/w : w == h ? 1 : 0;
	return 0;
}

int
synth_inside(const SynthDomain *d, double x, double y)
{
	double cx = (d->x0 + d->x1)/2, cy = (d->y0 + d->y1)/2;
	double a = (d->x1 - d->x0)/2, b = (d->y1 - d->y0)/2;

	if (d->shape == SYNTH_OVAL)
		return (x-cx)*(x-cx)/(a*a) + (y-cy)*(y-cy)/(b*b) <= 1;
	if (d->shape == SYNTH_SPHERE)
		return hypot(x - (x > SYNTH_FAR/2. ? SYNTH_FAR : 0), y) <= 1;
	if (d->shape == SYNTH_LSHAPE && x > cx && y > cy)
		return 0;
	return x >= d->x0 && x <= d->x1 && y >= d->y0 && y <= d->y1;
}
