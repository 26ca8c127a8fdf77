/* nodefields.c - sampled as the positions are, on the mesh of the map or one finer. */
#include <stdlib.h>

#include "nodefields.h"

/* Samples the field f at the nodes of the finished grid g.  x, y: their points of the rectangle. */
static int
sample_field(const Sampler *s, const Subdivision *mesh, const Disk *d, const double *f, const double *x,
	const double *y, Chart g, double **to)
{
	size_t nodes = (size_t)g.nu*g.nv;
	double *all = NULL;
	Channel channel = { .n = 1 };
	int e = SPD_ENOMEM;

	if (s->l.m->nv > d->m.nv && (all = malloc(s->l.m->nv*sizeof *all)))
		subdivision_extend(mesh, 1, f, all);
	channel.f = all ? all : (double *)f;
	*to = malloc(nodes*sizeof **to);
	if (*to && (all || s->l.m->nv == d->m.nv))
		e = sampler_channel(s, &channel, g.nu*g.nv, x, y, to) ? SPD_ENOMEM : 0;
	free(all);
	return e;
}

int
nodefields(const Sampler *s, const ChartMap *map, const Subdivision *mesh, const Disk *d,
	const ConformalOptions *o, Conformal *c)
{
	int n = c->grid.g.nu*c->grid.g.nv, p, k, e = 0;
	double *x;

	if (!o->fields)
		return 0;
	x = malloc(2*(size_t)n*sizeof *x);
	c->field = calloc(o->fields, sizeof *c->field);
	c->fields = c->field ? o->fields : 0;
	for (p = 0; x && p < n; p++)
		chartmap_point(map, c->grid.x[p], c->grid.y[p], &x[p], &x[n+p]);
	for (k = 0; x && !e && k < c->fields; k++)
		e = sample_field(s, mesh, d, o->field[k], x, x + n, c->grid.g, &c->field[k]);
	e = !x || !c->field ? SPD_ENOMEM : e;
	free(x);
	return e;
}
