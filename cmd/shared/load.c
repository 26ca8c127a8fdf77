/* load.c - reading mesh files. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../lib/mesh/disk.h"
#include "../../lib/meshfile/meshfile.h"
#include "beside.h"
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
load_soup(const char *path, unsigned what, Soup *s)
{
	size_t n;
	char *bytes = cmd_slurp_if(path, load_look, &n);

	load_bytes(path, bytes, n, what, s);
	free(bytes);
}

void
load_bytes(const char *path, const char *bytes, size_t n, unsigned what, Soup *s)
{
	MeshBeside beside;

	if (meshfile_parse_as(s, bytes, n, &(MeshParse){ claim_input(), what, beside_of(path, &beside) }))
		die("%s: %s", cmd_name_of(path), s->err);
}

void
load_range(const char *name, const Soup *s)
{
	double *x = cmd_alloc((size_t)s->first[s->nf] + 1, 3*sizeof *x);
	size_t n = 0;
	int i;

	for (i = 0; i < s->first[s->nf]; i++)
		if (s->idx[i] >= 0 && s->idx[i] < s->nv) {
			const double *y = s->xyz + 3*(size_t)s->idx[i];

			if (isfinite(y[0]) && isfinite(y[1]) && isfinite(y[2]))
				memcpy(x + 3*n++, y, 3*sizeof *x);
		}
	range_positions(name, n, 3, (const double *[]){ x, x + 1, x + 2 });
	free(x);
}

static void
load_by(int (*make)(Disk *, const Soup *), const char *name, const Soup *s, Disk *d)
{
	load_range(name, s);
	if (make(d, s))
		die("%s: %s", name, d->err);
	if (d->note[0])
		note("%s: %s", name, d->note);
}

void
load_disk(const char *name, const Soup *s, Disk *d)
{
	load_by(disk_from_soup, name, s, d);
}

void
load_disk_or_closed(const char *name, const Soup *s, Disk *d)
{
	load_by(disk_or_closed, name, s, d);
}
