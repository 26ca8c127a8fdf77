/* surface.c - a surface from a stream of grids or a mesh file, whichever it is. */
#include <stdlib.h>
#include <string.h>

#include "../lib/disk.h"
#include "../lib/gridmesh.h"
#include "../lib/meshfile.h"
#include "cmd.h"
#include "surface.h"

static const char magic[] = "lhg 1\n";

static void
from_grid(const char *name, char *bytes, size_t n, Mesh *m)
{
	CmdInput in = { .name = name };
	Lhg g;
	FILE *f = fmemopen(bytes, n, "rb");

	if (!f)
		die("%s: no memory", name);
	lhg_open(&in.s, f);
	if (lhg_read(&in.s, &g) < 0)
		die("%s: %s", name, in.s.err);
	if (g.frames > 1 || in.s.ahead)
		die("%s: holds several grids, want one", name);
	if (mesh_from_grid(m, g.nu, g.nv, cmd_need(&in, &g, "x", LHG_GRID),
	    cmd_need(&in, &g, "y", LHG_GRID), cmd_need(&in, &g, "z", LHG_GRID)))
		die("%s: no memory for a mesh of %d x %d vertices", name, g.nu, g.nv);
	lhg_free(&g);
	fclose(f);
}

static void
from_mesh(const char *name, const char *bytes, size_t n, Mesh *m)
{
	Soup s;
	Disk d;

	if (meshfile_parse(&s, bytes, n))
		die("%s: %s", name, s.err);
	if (disk_from_soup(&d, &s))
		die("%s: %s", name, d.err);
	if (d.note[0])
		note("%s: %s", name, d.note);
	soup_free(&s);
	*m = d.m;
	d.m = (Mesh){ 0, 0, NULL, NULL };       /* m's from now on */
	disk_free(&d);
}

void
surface_load(const char *path, Mesh *m)
{
	const char *name = cmd_name_of(path);
	size_t n;
	char *bytes = cmd_slurp(path, &n);

	if (n >= sizeof magic - 1 && !memcmp(bytes, magic, sizeof magic - 1))
		from_grid(name, bytes, n, m);
	else
		from_mesh(name, bytes, n, m);
	free(bytes);
}
