/* mesh.c - freeing and measuring meshes. */
#include <math.h>
#include <stdlib.h>

#include "channel.h"
#include "mesh.h"

void
soup_free(Soup *s)
{
	free(s->xyz);
	free(s->first);
	free(s->idx);
	free(s->filled);
	channels_free(&s->channels);
	free(s->facts);
	free(s->left_out);
	s->xyz = NULL;
	s->filled = NULL;
	s->facts = s->left_out = NULL;
	s->first = s->idx = NULL;
	s->nv = s->nf = 0;
}

void
mesh_free(Mesh *m)
{
	free(m->xyz);
	free(m->tri);
	m->xyz = NULL;
	m->tri = NULL;
	m->nv = m->nf = 0;
}

void
disk_free(Disk *d)
{
	mesh_free(&d->m);
	free(d->loop);
	free(d->twin);
	free(d->file);
	free(d->became);
	channels_free(&d->channels);
	d->loop = d->twin = d->file = d->became = NULL;
	d->nb = d->nfile = 0;
}

double
mesh_area(const Mesh *m)
{
	double u[3], v[3], sum = 0;
	int f, c;

	for (f = 0; f < m->nf; f++) {
		const int *t = m->tri + 3*(size_t)f;
		const double *a = m->xyz + 3*(size_t)t[0];
		const double *b = m->xyz + 3*(size_t)t[1], *e = m->xyz + 3*(size_t)t[2];

		for (c = 0; c < 3; c++)
			u[c] = b[c] - a[c], v[c] = e[c] - a[c];
		sum += hypot(hypot(u[1]*v[2] - u[2]*v[1], u[2]*v[0] - u[0]*v[2]),
		    u[0]*v[1] - u[1]*v[0]) / 2;
	}
	return sum;
}
