/* disksoup.c - numbers at the vertices of a disk, copied to its soup. */
#include <math.h>
#include <stdlib.h>

#include "channel.h"
#include "disksoup.h"
#include "fail.h"

int
disk_channel_to_soup(const Disk *d, const char *name, int n, const double *f, double none, Soup *s)
{
	double *to = channel_add(&s->channels, name, n, (size_t)s->nv);
	int i, k;

	if (!to)
		return mesh_fail(s->err, MESH_ENOMEM, "no memory for %d x %d numbers", s->nv, n);
	for (i = 0; i < s->nv; i++, to += n)
		for (k = 0; k < n; k++)
			to[k] = d->became[i] < 0 ? none : f[(size_t)n*(size_t)d->became[i] + (size_t)k];
	return 0;
}

int
disk_uv_to_soup(const Disk *d, const double *u, const double *v, double T, Soup *s)
{
	double *uv = mesh_alloc(s->err, (size_t)d->m.nv, 2 * sizeof *uv);
	size_t i;
	int e;

	if (!uv)
		return MESH_ENOMEM;
	for (i = 0; i < (size_t)d->m.nv; i++) {
		uv[2*i] = fmin(fmax(u[i], 0), 1);
		uv[2*i+1] = fmin(fmax(v[i], 0), T);
	}
	s->T = T;
	e = disk_channel_to_soup(d, MESH_UV, 2, uv, -1, s);
	free(uv);
	return e;
}
