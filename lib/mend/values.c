/* values.c - numbers at the vertices that mending made. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../mesh/channel.h"
#include "../mesh/fail.h"
#include "../mesh/spread.h"
#include "values.h"

static void
channel(const Spread *a, Channel *c)
{
	const int whole = channel_whole(c->type);
	int q, k;

	if (whole && !channel_colour(c)) {
		spread_nearest(a, c->n, c->f);
		return;
	}
	spread_mean(a, c->n, c->f);
	for (q = 0; q < a->n && whole; q++)
		for (k = 0; k < c->n; k++) {
			double *x = c->f + (size_t)c->n*(size_t)a->vertex[q] + (size_t)k;

			*x = rint(*x);
		}
}

/* Makes the mean of normals one of length 1, if they have a direction. */
static void
normals(const Spread *a, const Channels *c)
{
	double *x = channel_values(c, "nx"), *y = channel_values(c, "ny"), *z = channel_values(c, "nz"), length;
	int q, v;

	for (q = 0; q < a->n && x && y && z; q++) {
		v = a->vertex[q];
		length = sqrt(x[v]*x[v] + y[v]*y[v] + z[v]*z[v]);
		if (length > 0 && length < HUGE_VAL)
			x[v] /= length, y[v] /= length, z[v] /= length;
	}
}

int
values_made(Soup *s, const int *source)
{
	unsigned char *known = mesh_alloc(s->err, (size_t)s->nv, 1);
	int v, k, made = 0, e = known ? 0 : MESH_ENOMEM;
	Spread a;

	for (v = 0; !e && v < s->nv; v++)
		made += !(known[v] = source[v] >= 0);
	if (!e && made && s->channels.n && (e = spread_init(&a, s, known)) == 0) {
		for (k = 0; k < s->channels.n; k++)
			if (strcmp(s->channels.channel[k].name, MESH_SOURCE) != 0)
				channel(&a, &s->channels.channel[k]);
		normals(&a, &s->channels);
		spread_free(&a);
	}
	free(known);
	return e ? mesh_fail(s->err, e, "no memory for numbers at %d vertices", s->nv) : 0;
}
