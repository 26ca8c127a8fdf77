/* load.c - mesh files for the commands that read them. */
#include <stdlib.h>

#include "../../lib/mesh/disk.h"
#include "../../lib/meshfile/meshfile.h"
#include "cmd.h"
#include "load.h"
#include "range.h"

void
load_soup(const char *path, Soup *s)
{
	size_t n;
	char *bytes = cmd_slurp(path, &n);

	if (meshfile_parse(s, bytes, n))
		die("%s: %s", cmd_name_of(path), s->err);
	free(bytes);
	range_positions(cmd_name_of(path), (size_t)s->nv, 3, (const double *[]){ s->xyz, s->xyz + 1, s->xyz + 2 });
}

void
load_both(const char *path, Soup *s, Disk *d)
{
	load_soup(path, s);
	if (disk_from_soup(d, s))
		die("%s: %s", cmd_name_of(path), d->err);
	if (d->note[0])
		note("%s: %s", cmd_name_of(path), d->note);
}
