/* withopt.c - fields at the vertices become channels of the grid. */
#include <stdlib.h>
#include <string.h>

#include "../../lib/mesh/channel.h"
#include "../../lib/meshfile/fieldfile.h"
#include "../shared/beside.h"
#include "../shared/cmd.h"
#include "carry.h"
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

static void
read_file(const char *path, Soup *s)
{
	char name[CHANNEL_NAME], err[MESH_ERRLEN], *bytes;
	const double *source;
	MeshBeside beside;
	FieldFile f;
	size_t n;
	int k;

	stem(path, name);
	bytes = cmd_slurp(path, &n);
	if (fieldfile_parse(bytes, n, name, beside_of(path, &beside), &f, err))
		die("%s: %s", path, err);
	free(bytes);
	source = carry_source(path, &f, s);
	for (k = 0; k < f.c.n; k++) {
		double *to;

		clean(f.c.channel[k].name);
		f.c.channel[k].name[LHG_NAMELEN - 1] = '\0';
		if (channel_find(&s->channels, f.c.channel[k].name))
			die("%s: a second channel %s", path, f.c.channel[k].name);
		if (!(to = channel_add(&s->channels, f.c.channel[k].name, 1, (size_t)s->nv)))
			die("%s: no memory for %d numbers", path, s->nv);
		carry_numbers(s, source, f.c.channel[k].f, to);
	}
	fieldfile_free(&f);
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
