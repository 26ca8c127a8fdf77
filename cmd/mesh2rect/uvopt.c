/* uvopt.c - the option --uv of mesh2rect. */
#include <stdlib.h>
#include <string.h>

#include <unistd.h>

#include "../../lib/grid/detail.h"
#include "../../lib/mesh/channel.h"
#include "../../lib/mesh/disksoup.h"
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
		misuse("--uv=%s: the mesh is read from there, and would lose what FILE has no place for", file);
}

/* Adds the channel MESH_OFFSET to s, computed from the (u,v) of s and the grid phi. */
static void
add_offsets(const char *file, Soup *s, Chart g, const double *const phi[3])
{
	const double *uv = channel_values(&s->channels, MESH_UV);
	double *o = channel_add(&s->channels, MESH_OFFSET, DETAIL_SIZE, (size_t)s->nv);
	Detail d;
	int p;

	if (!o || detail_init(&d, g, phi))
		die("%s: no memory for the offsets of %d vertices", file, s->nv);
	for (p = 0; p < s->nv; p++, uv += 2, o += DETAIL_SIZE)
		if (uv[0] == -1 && uv[1] == -1)
			memset(o, 0, DETAIL_SIZE*sizeof *o);
		else
			detail_offset(&d, uv[0], uv[1], s->xyz + 3*(size_t)p, o);
	detail_free(&d);
}

void
uv_set_aside(Soup *s, Channels *own)
{
	int k, n = 0;

	*own = (Channels){ 0, cmd_alloc((size_t)s->channels.n + 1, sizeof *own->channel) };
	for (k = 0; k < s->channels.n; k++)
		if (strcmp(s->channels.channel[k].name, MESH_SOURCE) == 0)
			s->channels.channel[n++] = s->channels.channel[k];
		else
			own->channel[own->n++] = s->channels.channel[k];
	s->channels.n = n;
}

static void
add_own(const char *file, Soup *s, Channels *own)
{
	const size_t nv = (size_t)s->nv;
	double *f;
	int k;

	for (k = 0; k < own->n; k++) {
		const Channel *c = &own->channel[k];

		if (channel_find(&s->channels, c->name))
			continue;
		if (!(f = channel_add(&s->channels, c->name, c->n, nv)))
			die("%s: no memory for %s at %d vertices", file, c->name, s->nv);
		memcpy(f, c->f, nv*(size_t)c->n*sizeof *f);
		channel_find(&s->channels, c->name)->type = c->type;
	}
	channels_free(own);
}

void
uv_write(const char *file, Soup *s, Channels *own, const Disk *d, const double *u, const double *v, Chart g,
	const double *const phi[3])
{
	char *bytes;
	size_t n;

	if (disk_uv_to_soup(d, u, v, g.T, s))
		die("%s: %s", file, s->err);
	s->chart = g.kind;
	add_offsets(file, s, g, phi);
	add_own(file, s, own);
	if (s->filled && strcmp(meshformat_of(file)->name, "PLY") != 0)
		note("%s: only PLY marks the faces that fill holes: grid2mesh --on will keep them", file);
	if (meshfile_write(s, meshformat_of(file), &bytes, &n))
		die("%s: no memory for a mesh of %d vertices", file, s->nv);
	cmd_write_bytes(file, bytes, n);
	free(bytes);
}
