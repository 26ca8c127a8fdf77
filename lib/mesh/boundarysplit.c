/* boundarysplit.c - the longest boundary edge, split at its middle. */
#include <math.h>
#include <stdlib.h>

#include "../base/vec3.h"
#include "boundarysplit.h"
#include "subdivision.h"
#include "topology.h"

/* The side of the longest boundary edge. */
static int
longest_side(const Disk *d)
{
	double longest = -1;
	int i, s, side = -1, *from = d->loop;

	for (i = 0; i < d->nb; i++) {
		const double *a = &d->m.xyz[3*(size_t)from[i]], *b = &d->m.xyz[3*(size_t)from[(i+1)%d->nb]];
		double x[3], length;

		sub3(a, b, x);
		length = hypot(hypot(x[0], x[1]), x[2]);
		for (s = 0; s < 3*d->m.nf && length > longest*(1 + 1e-12); s++)
			if (d->twin[s] < 0 && d->m.tri[s] == from[i]) {
				longest = length;
				side = s;
			}
	}
	return side;
}

/* Extends the channels and the file numbers of d to the new vertex. */
static int
extend_numbers(const Subdivision *s, Disk *d)
{
	int k, nv = s->d.m.nv, *file = realloc(d->file, nv*sizeof *file);

	if (!file)
		return MESH_ENOMEM;
	d->file = file;
	file[nv-1] = -1;
	for (k = 0; k < d->channels.n; k++) {
		Channel *c = &d->channels.channel[k];
		double *f = realloc(c->f, (size_t)nv*c->n*sizeof *f);

		if (!f)
			return MESH_ENOMEM;
		c->f = f;
		subdivision_extend(s, c->n, f, f);
	}
	return 0;
}

int
boundary_split(Disk *d)
{
	Subdivision s;
	SurfacePoint middle = subdivision_on_side(longest_side(d), 0.5);
	int e = subdivision_init(&s, d);

	if (e)
		return e;
	if (subdivision_add(&s, 1, &middle) != 1 || extend_numbers(&s, d)) {
		subdivision_free(&s);
		return MESH_ENOMEM;
	}
	mesh_free(&d->m);
	free(d->loop);
	free(d->twin);
	d->m = s.d.m;
	d->loop = s.d.loop;
	d->twin = s.d.twin;
	d->nb = s.d.nb;
	s.d = (Disk){ 0 };
	subdivision_free(&s);
	return 0;
}

int
boundary_split_turned(const Disk *d, const double *u, const double *v)
{
	int added = d->m.nv - 1, s, c[3] = { 0, 0, 0 };

	if (!d->file || d->file[added] >= 0)
		return 0;
	for (s = 0; s < 3*d->m.nf; s++)
		if (d->twin[s] < 0 && d->m.tri[s] == added) {
			c[1] = d->m.tri[topology_next(s)];
			c[2] = d->m.tri[topology_next(topology_next(s))];
		} else if (d->twin[s] < 0 && d->m.tri[topology_next(s)] == added)
			c[0] = d->m.tri[s];
	return mesh_image(c, u, v) < 0;
}
