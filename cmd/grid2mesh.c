/* grid2mesh - a gridded surface as a triangle mesh */
#include <stdlib.h>
#include <string.h>

#include "../lib/gridmesh.h"
#include "../lib/meshfile.h"
#include "cmd.h"

static const char text[] =
"usage: grid2mesh [-o FILE] [GRID] >mesh.off\n"
"reads channels x y z; writes a mesh of nu nv vertices, row by row, and two triangles a\n"
"cell, parted by its shorter diagonal, their normals along x_u cross x_v\n"
"  -o, --output=FILE  write FILE, by its end .off .obj .ply or .stl [OFF to stdout]; a\n"
"                     stream of several grids needs a number in FILE, as frame-%03d.off,\n"
"                     from 1; each file is whole or it is not there\n"
"  -q, --quiet        no notes on stderr\n"
"  -v, --verbose      more words on stderr\n"
"  -h, --help         print this text\n"
"      --version      print the version\n";

static const struct option longopt[] = { CMD_LONGOPT };

/* Splits "frame-%03d.off" into what stands before and after the number and its width;
 * 0 when there is no number in the name. */
static int
numbered(const char *name, size_t *before, int *width, const char **after)
{
	const char *s = strchr(name, '%');
	char *end;

	if (!s)
		return 0;
	*before = s - name;
	*width = strtol(s + 1, &end, 10);
	if (*end != 'd' || end - s > 4 || *width < 0 || strchr(end, '%'))
		misuse("--output=%s: need one %%d or %%03d and no other %%", name);
	*after = end + 1;
	return 1;
}

/* The name of file number i, in out. */
static const char *
file_name(const char *name, int i, char *out, size_t n)
{
	const char *after;
	size_t before;
	int width;

	if (!name || !numbered(name, &before, &width, &after))
		return name;
	if ((size_t)snprintf(out, n, "%.*s%0*d%s", (int)before, name, width, i, after) >= n)
		die("%s: name too long", name);
	return out;
}

static void
emit(const CmdInput *in, const Lhg *g, int kind, const char *path)
{
	const double *x = cmd_need(in, g, "x", LHG_GRID), *y = cmd_need(in, g, "y", LHG_GRID);
	const double *z = cmd_need(in, g, "z", LHG_GRID);
	char *bytes = NULL;
	size_t n;
	int e;
	Mesh m;

	e = mesh_from_grid(&m, g->nu, g->nv, x, y, z);
	if (!e)
		e = meshfile_format(&m, kind, &bytes, &n);
	if (e == MESH_EVALUE)
		die("%s: a coordinate is too large for STL", in->name);
	if (e)
		die("%s: no memory for a mesh of %d x %d vertices", in->name, g->nu, g->nv);
	mesh_free(&m);
	cmd_emit(path, bytes, n);
	free(bytes);
}

int
main(int argc, char *argv[])
{
	char path[4096];
	const char *name, *after;
	int kind = MESHFILE_OFF, many, width, i = 0;
	size_t before;
	CmdInput in;
	Lhg g;

	cmd_begin("grid2mesh", text);
	while (cmd_getopt(argc, argv, "", longopt) != -1)
		;
	cmd_operands(argc, argv, 0, 1);
	name = cmd_output();
	if (name && (kind = meshfile_kind(name)) < 0)
		misuse("--output=%s: need an end of .off .obj .ply or .stl", name);
	many = name && numbered(name, &before, &width, &after);

	cmd_open(&in, argv[optind]);
	while (cmd_read(&in, &g)) {
		if (!many && (g.frames > 1 || in.s.ahead))
			die("%s: holds several grids: name the files by -o NAME-%%03d.off", in.name);
		emit(&in, &g, kind, file_name(name, ++i, path, sizeof path));
		lhg_free(&g);
	}
	return cmd_end();
}
