/* uvopt.c - the option --uv of mesh2rect. */
#include <stdlib.h>

#include "../../lib/mesh/disk.h"
#include "../../lib/meshfile/meshfile.h"
#include "../shared/cmd.h"
#include "uvopt.h"

void
opt_uv(const char *file)
{
	const int kind = meshfile_kind(file);

	if (kind != MESHFILE_OBJ && kind != MESHFILE_PLY)
		misuse("--uv=%s: need an end of .obj or .ply", file);
}

void
uv_write(const char *file, Soup *s, const Disk *d, const double *u, const double *v, double T)
{
	char *bytes;
	size_t n;

	if (disk_uv(d, u, v, T, s))
		die("%s: %s", file, s->err);
	if (meshfile_format_soup(s, meshfile_kind(file), &bytes, &n))
		die("%s: no memory for a mesh of %d vertices", file, s->nv);
	cmd_emit(file, bytes, n);
	free(bytes);
}
