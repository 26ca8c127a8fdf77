/* uvopt.c - the option --uv of mesh2rect. */
#include <stdlib.h>

#include <unistd.h>

#include "../../lib/mesh/disk.h"
#include "../../lib/meshfile/meshfile.h"
#include "../shared/cmd.h"
#include "../shared/samefile.h"
#include "uvopt.h"

void
opt_uv(const char *file, const char *mesh)
{
	const MeshFormat *format = meshformat_of(file);
	const char *out = cmd_output();
	char list[MESHFORMAT_LIST];

	if (!format || !(format->can & MESHFORMAT_UV))
		misuse("--uv=%s: need a name that ends in %s", file,
			meshformat_ends(MESHFORMAT_UV | MESHFORMAT_WRITE, list));
	if (out ? same_file(file, out) : same_as_stream(file, STDOUT_FILENO))
		misuse("--uv=%s: the grid is written there, by --output", file);
	if (cmd_name_of(mesh) == mesh ? same_file(file, mesh) : same_as_stream(file, STDIN_FILENO))
		misuse("--uv=%s: the mesh is read from there, and would lose all but positions and faces", file);
}

void
uv_write(const char *file, Soup *s, const Disk *d, const double *u, const double *v, double T)
{
	char *bytes;
	size_t n;

	if (disk_uv_to_soup(d, u, v, T, s))
		die("%s: %s", file, s->err);
	if (meshfile_write(s, meshformat_of(file), &bytes, &n))
		die("%s: no memory for a mesh of %d vertices", file, s->nv);
	cmd_write_bytes(file, bytes, n);
	free(bytes);
}
