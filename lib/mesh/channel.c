/* channel.c - named numbers at the vertices of a mesh. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "channel.h"

Channel *
channel_find(const Channels *c, const char *name)
{
	int k;

	for (k = 0; k < c->n; k++)
		if (strcmp(c->channel[k].name, name) == 0)
			return &c->channel[k];
	return NULL;
}

double *
channel_values(const Channels *c, const char *name)
{
	const Channel *found = channel_find(c, name);

	return found ? found->f : NULL;
}

const double *
channel_source(const Channels *c, int nv, int most)
{
	const double *source = channel_values(c, MESH_SOURCE);
	int p;

	for (p = 0; p < nv && source; p++)
		if (!(source[p] >= -1 && source[p] < most))
			return NULL;
	return source;
}

double *
channel_add(Channels *c, const char *name, int n, size_t nv)
{
	double *f = channel_values(c, name);
	Channel *more;

	if (f)
		return f;
	if (!(more = realloc(c->channel, ((size_t)c->n + 1)*sizeof *more)))
		return NULL;
	c->channel = more;
	more += c->n;
	*more = (Channel){ .n = n };
	snprintf(more->name, sizeof more->name, "%s", name);
	if (nv <= SIZE_MAX/2/sizeof *f/(size_t)n)
		more->f = malloc(nv ? nv*(size_t)n*sizeof *f : 1);
	c->n += more->f != NULL;
	return more->f;
}

int
channels_gather(Channels *to, const Channels *from, int nv, const int *vertex, double none)
{
	const Channel *c;
	double *f;
	int i, k;

	for (c = from->channel; c < from->channel + from->n; c++) {
		if (!(f = channel_add(to, c->name, c->n, (size_t)nv))) {
			channels_free(to);
			return MESH_ENOMEM;
		}
		for (i = 0; i < nv; i++, f += c->n)
			for (k = 0; k < c->n; k++)
				f[k] = vertex[i] < 0 ? none : c->f[(size_t)c->n*(size_t)vertex[i] + (size_t)k];
	}
	return 0;
}

void
channels_free(Channels *c)
{
	while (c->n > 0)
		free(c->channel[--c->n].f);
	free(c->channel);
	c->channel = NULL;
}
