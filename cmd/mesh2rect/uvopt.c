/* uvopt.c - the option --uv of mesh2rect. */
#include <stdlib.h>

#include "../../lib/mesh/disk.h"
#include "../../lib/meshfile/meshfile.h"
#include "../shared/cmd.h"
#include "uvopt.h"

void
opt_uv(const char *file)
{
	const MeshFormat *format = meshformat_of(file);
	char list[MESHFORMAT_LIST];

	if (!format || !(format->can & MESHFORMAT_UV))
		misuse("--uv=%s: need an end of %s", file, meshformat_ends(MESHFORMAT_UV | MESHFORMAT_WRITE, list));
}

void
uv_write(const char *file, Soup *s, const Disk *d, const double *u, const double *v, double T)
{
	char *bytes;
	size_t n;

	if (disk_uv(d, u, v, T, s))
		die("%s: %s", file, s->err);
	if (meshfile_write(s, meshformat_of(file), &bytes, &n))
		die("%s: no memory for a mesh of %d vertices", file, s->nv);
	cmd_emit(file, bytes, n);
	free(bytes);
}
