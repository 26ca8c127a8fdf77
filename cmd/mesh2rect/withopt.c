/* withopt.c - fields at the vertices become channels of the grid. */
#include <stdlib.h>
#include <string.h>

#include "../../lib/mesh/channel.h"
#include "../../lib/meshfile/fieldfile.h"
#include "../shared/beside.h"
#include "../shared/cmd.h"
#include "withopt.h"

/* Whether d's channel was read by --with, and can be a channel of a grid. */
static int
is_field(const Channel *c)
{
	return c->n == 1 && strcmp(c->name, MESH_SOURCE) != 0;
}

/* The name of the file without its folder and without what follows a dot, or the part behind the first dot for
 * names as lh.sulc. */
static void
stem(const char *path, char name[CHANNEL_NAME])
{
	const char *slash = strrchr(path, '/'), *from = slash ? slash + 1 : path, *dot;
	size_t n;

	if (strncmp(from, "lh.", 3) == 0 || strncmp(from, "rh.", 3) == 0)
		from += 3;
	dot = strchr(from, '.');
	n = dot ? (size_t)(dot - from) : strlen(from);
	n = n < CHANNEL_NAME - 1 ? n : CHANNEL_NAME - 1;
	memcpy(name, from, n);
	name[n] = '\0';
}

/* Replaces what LHG.md does not allow in the name of a channel. */
static void
clean(char *name)
{
	for (; *name; name++)
		if (!strchr("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789._+-", *name))
			*name = '_';
}

/* Gives each vertex that has none (known 0) the mean of its neighbours' numbers, from face to face; 0 if no face
 * leads to it. */
static void
spread(const Soup *s, unsigned char *known, double *f)
{
	double *sum = cmd_alloc((size_t)s->nv, sizeof *sum);
	int *n = cmd_alloc((size_t)s->nv, sizeof *n), k, i, p, found;

	do {
		found = 0;
		memset(sum, 0, (size_t)s->nv*sizeof *sum);
		memset(n, 0, (size_t)s->nv*sizeof *n);
		for (k = 0; k < s->nf; k++)
			for (i = s->first[k]; i < s->first[k+1]; i++)
				for (p = s->first[k]; p < s->first[k+1] && !known[s->idx[i]]; p++)
					if (known[s->idx[p]]) {
						sum[s->idx[i]] += f[s->idx[p]];
						n[s->idx[i]]++;
					}
		for (p = 0; p < s->nv; p++)
			if (n[p]) {
				f[p] = sum[p]/n[p];
				known[p] = 1;
				found = 1;
			}
	} while (found);
	free(sum);
	free(n);
}

/* Sets `to` to the numbers `from` of a file of nv vertices: those of s, or those of the file that s was made from, by
 * the channel MESH_SOURCE. */
static void
carry(const Soup *s, const double *source, int nv, const double *from, double *to)
{
	unsigned char *known;
	int p;

	if (nv == s->nv) {
		memcpy(to, from, (size_t)nv*sizeof *to);
		return;
	}
	known = cmd_alloc((size_t)s->nv, 1);
	for (p = 0; p < s->nv; p++) {
		known[p] = source[p] >= 0;
		to[p] = known[p] ? from[(int)source[p]] : 0;
	}
	spread(s, known, to);
	free(known);
}

static void
read_file(const char *path, Soup *s)
{
	char name[CHANNEL_NAME], err[MESH_ERRLEN], *bytes;
	MeshBeside beside;
	Channels c;
	size_t n;
	int k, nv;

	stem(path, name);
	bytes = cmd_slurp(path, &n);
	if (fieldfile_parse(bytes, n, name, beside_of(path, &beside), &c, &nv, err))
		die("%s: %s", path, err);
	if (nv != s->nv && !channel_source(&s->channels, s->nv, nv))
		die("%s: %d numbers, the mesh has %d vertices", path, nv, s->nv);
	for (k = 0; k < c.n; k++) {
		double *to;

		clean(c.channel[k].name);
		if (channel_find(&s->channels, c.channel[k].name))
			die("%s: a second channel %s", path, c.channel[k].name);
		if (!(to = channel_add(&s->channels, c.channel[k].name, 1, (size_t)s->nv)))
			die("%s: no memory for %d numbers", path, s->nv);
		carry(s, channel_values(&s->channels, MESH_SOURCE), nv, c.channel[k].f, to);
	}
	channels_free(&c);
	free(bytes);
}

void
with_read(const char *files, Soup *s)
{
	char *copy = cmd_alloc(strlen(files) + 1, 1), *word = copy, *comma;

	strcpy(copy, files);
	for (; word; word = comma) {
		if ((comma = strchr(word, ',')))
			*comma++ = '\0';
		read_file(word, s);
	}
	free(copy);
}

void
with_fields(const Disk *d, ConformalOptions *o)
{
	const double **f = cmd_alloc(d->channels.n + 1, sizeof *f);
	int k;

	o->fields = 0;
	for (k = 0; k < d->channels.n; k++)
		if (is_field(&d->channels.channel[k]))
			f[o->fields++] = d->channels.channel[k].f;
	o->field = f;
}

void
with_write(const Disk *d, const Conformal *c, Lhg *out)
{
	int k, i = 0;

	for (k = 0; k < d->channels.n; k++)
		if (is_field(&d->channels.channel[k])) {
			if (lhg_find(out, d->channels.channel[k].name))
				die("--with: a channel %s is there already", d->channels.channel[k].name);
			memcpy(cmd_add(out, d->channels.channel[k].name, "1", LHG_GRID, 0), c->field[i++],
			    (size_t)out->nu*out->nv*sizeof(double));
		}
}
