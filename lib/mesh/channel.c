/* channel.c - named numbers at the vertices of a mesh. */
#include <float.h>
#include <math.h>
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

int
channel_whole(ChannelType type)
{
	return type >= CHANNEL_INT8 && type <= CHANNEL_UINT32;
}

int
channel_colour(const Channel *c)
{
	return c->n == 1 && (strcmp(c->name, "red") == 0 || strcmp(c->name, "green") == 0 || strcmp(c->name, "blue") == 0 ||
	    strcmp(c->name, "alpha") == 0);
}

int
channel_holds(ChannelType type, double x)
{
	static const struct { double lo, hi; } whole[] = { [CHANNEL_INT8] = { -128, 127 }, [CHANNEL_UINT8] = { 0, 255 },
		[CHANNEL_INT16] = { -32768, 32767 }, [CHANNEL_UINT16] = { 0, 65535 },
		[CHANNEL_INT32] = { -2147483648.0, 2147483647 }, [CHANNEL_UINT32] = { 0, 4294967295.0 } };

	if (channel_whole(type))
		return x >= whole[type].lo && x <= whole[type].hi && x == rint(x);
	return type != CHANNEL_FLOAT || !isfinite(x) || fabs(x) <= (double)FLT_MAX;
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
	int i, j, k;

	for (j = 0; j < from->n; j++) {
		c = &from->channel[j];
		if (!(f = channel_add(to, c->name, c->n, (size_t)nv))) {
			channels_free(to);
			return MESH_ENOMEM;
		}
		channel_find(to, c->name)->type = c->type;
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
