/* load.c - reading mesh files. */
#include <stdlib.h>

#include "../../lib/mesh/disk.h"
#include "../../lib/meshfile/meshfile.h"
#include "claim.h"
#include "cmd.h"
#include "load.h"
#include "range.h"

void
load_look(const char *name, const char *head, size_t n)
{
	char err[MESH_ERRLEN];

	if (meshfile_plausible(head, n, claim_input(), err))
		die("%s: %s", name, err);
}

void
load_soup(const char *path, int uv, Soup *s)
{
	size_t n;
	char *bytes = cmd_slurp_if(path, load_look, &n);

	load_bytes(cmd_name_of(path), bytes, n, uv, s);
}

void
load_bytes(const char *name, char *bytes, size_t n, int uv, Soup *s)
{
	if ((uv ? meshfile_parse_uv : meshfile_parse)(s, bytes, n, claim_input()))
		die("%s: %s", name, s->err);
	free(bytes);
}

void
load_disk(const char *name, const Soup *s, Disk *d)
{
	range_positions(name, (size_t)s->nv, 3, (const double *[]){ s->xyz, s->xyz + 1, s->xyz + 2 });
	if (disk_from_soup(d, s))
		die("%s: %s", name, d->err);
	if (d->note[0])
		note("%s: %s", name, d->note);
}
