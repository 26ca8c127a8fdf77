/* surface.c - the surfaces of an operand: a stream of grids or a mesh file. */
#include <stdlib.h>
#include <string.h>

#include "../../lib/grid/gridmesh.h"
#include "../../lib/mesh/disk.h"
#include "../shared/chartof.h"
#include "../shared/load.h"
#include "../shared/range.h"
#include "surface.h"

void
surfaces_open(Surfaces *s, const char *path)
{
	*s = (Surfaces){ .path = path };
	s->grids = cmd_open_or_slurp(&s->in, path, load_look, &s->bytes, &s->n);
}

static int
from_grid(CmdInput *in, Mesh *m)
{
	const double *phi[3];
	Lhg g;

	if (!cmd_read(in, &g))
		return 0;
	phi[0] = cmd_need(in, &g, "x", LHG_GRID);
	phi[1] = cmd_need(in, &g, "y", LHG_GRID);
	phi[2] = cmd_need(in, &g, "z", LHG_GRID);
	if (mesh_from_grid(m, chart_of(&g), phi))
		die("%s: no memory for a mesh of %d x %d vertices", in->name, g.nu, g.nv);
	range_positions(in->name, (size_t)m->nv, 3, (const double *[]){ m->xyz, m->xyz + 1, m->xyz + 2 });
	lhg_free(&g);
	return 1;
}

/* Makes d from the faces of a mesh file, which need not form a disk or a closed surface. */
static void
faces(const char *name, const Soup *soup, Disk *d)
{
	char fault[MESH_ERRLEN];
	int e;

	range_positions(name, (size_t)soup->nv, 3, (const double *[]){ soup->xyz, soup->xyz + 1,
		soup->xyz + 2 });
	if ((e = disk_or_closed(d, soup)) == MESH_ENOMEM)
		die("%s: %s", name, d->err);
	if (e) {
		memcpy(fault, d->err, sizeof fault);
		if (disk_loose(d, soup))
			die("%s: %s", name, d->err);
		note("%s: not a disk, compared as it is: %s", name, fault);
	}
	if (d->note[0])
		note("%s: %s", name, d->note);
}

static int
from_mesh(Surfaces *s, Mesh *m)
{
	Soup soup;
	Disk d;

	if (!s->bytes)
		return 0;
	load_bytes(s->path, s->bytes, s->n, 0, &soup);
	free(s->bytes);
	s->bytes = NULL;
	faces(s->in.name, &soup, &d);
	soup_free(&soup);
	*m = d.m;
	d.m = (Mesh){ 0, 0, NULL, NULL };       /* the mesh belongs to m now */
	disk_free(&d);
	return 1;
}

int
surfaces_next(Surfaces *s, Mesh *m)
{
	if (!(s->grids ? from_grid(&s->in, m) : from_mesh(s, m)))
		return 0;
	s->count++;
	if (s->count > 1 || surfaces_more(s))
		snprintf(s->place, sizeof s->place, "%.250s: grid %ld", s->in.name, s->count);
	else
		snprintf(s->place, sizeof s->place, "%.250s", s->in.name);
	return 1;
}

int
surfaces_more(const Surfaces *s)
{
	return s->grids && (s->in.s.frame < s->in.s.frames || s->in.s.ahead);
}
