/* gridfile.c - a grid as the bytes of a mesh file, for grid2mesh. */
#include <stdlib.h>
#include <string.h>

#include "../../lib/grid/gridmesh.h"
#include "../../lib/grid/gridpoint.h"
#include "../../lib/mesh/channel.h"
#include "../../lib/meshfile/meshfile.h"
#include "../shared/chartof.h"
#include "../shared/load.h"
#include "gridfile.h"

void
gridfile_read_mesh(const char *path, Soup *s)
{
	const double *uv;
	int p, none = 0;

	load_soup(path, 1, s);
	uv = channel_values(&s->channels, MESH_UV);
	for (p = 0; p < s->nv; p++)
		none += uv[2*(size_t)p] == -1 && uv[2*(size_t)p+1] == -1;
	if (none)
		note("%s: %d %s without (u,v) %s in place", cmd_name_of(path), none,
		    none == 1 ? "vertex" : "vertices", none == 1 ? "stays" : "stay");
}

static void
mesh_of_grid(const CmdInput *in, const Lhg *g, const double *const phi[3], const MeshFormat *format,
	char **bytes, size_t *n)
{
	Mesh m;
	int left = 0, e = mesh_from_grid(&m, g->nu, g->nv, phi[0], phi[1], phi[2]);

	if (!e)
		e = gridmesh_part(&m, g->nu, g->nv, (format->can & MESHFORMAT_SINGLE) != 0, &left);
	if (left)
		note("%s: %d faces without area, or nodes at one place: cells smaller than %s can hold", in->name,
		    left, format->name);
	if (!e)
		e = meshfile_write_mesh(&m, format, bytes, n);
	if (e == MESH_EVALUE)
		die("%s: a coordinate is too large for %s", in->name, format->name);
	if (e)
		die("%s: no memory for a mesh of %d x %d vertices", in->name, g->nu, g->nv);
	mesh_free(&m);
}

static void
moved_mesh(const Lhg *g, const double *const phi[3], const Soup *on, const char *name,
	const MeshFormat *format, char **bytes, size_t *n)
{
	const Chart chart = chart_of(g);
	const double *was = channel_values(&on->channels, MESH_UV);
	Soup s = *on;
	double *uv;
	int at;

	s.T = g->T;
	s.xyz = cmd_alloc((size_t)on->nv, 3*sizeof *s.xyz);
	memcpy(s.xyz, on->xyz, 3*(size_t)on->nv*sizeof *s.xyz);
	s.channels = (Channels){ 0 };
	if (!(uv = channel_add(&s.channels, MESH_UV, 2, (size_t)on->nv)))
		die("%s: no memory for the (u,v) of %d vertices", name, on->nv);
	if (gridpoint_uv(chart, on->T, on->nv, was, uv, &at))
		die("%s: vertex %d has (u,v) = (%g,%g), outside [0,1] x [0,%g]", name, at,
		    was[2*(size_t)at], was[2*(size_t)at+1], on->T > 0 ? on->T : g->T);
	gridpoint_vertices(chart, 3, phi, on->nv, uv, s.xyz);
	if (meshfile_write(&s, format, bytes, n))
		die("%s: no memory for a mesh of %d vertices", name, s.nv);
	free(s.xyz);
	channels_free(&s.channels);
}

void
gridfile_bytes(const CmdInput *in, const Lhg *g, const Soup *on, const char *onname,
	const MeshFormat *format, char **bytes, size_t *n)
{
	const double *phi[3];

	phi[0] = cmd_need(in, g, "x", LHG_GRID);
	phi[1] = cmd_need(in, g, "y", LHG_GRID);
	phi[2] = cmd_need(in, g, "z", LHG_GRID);
	if (on)
		moved_mesh(g, phi, on, onname, format, bytes, n);
	else
		mesh_of_grid(in, g, phi, format, bytes, n);
}
