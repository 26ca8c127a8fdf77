/* gridfile.c - a grid as the bytes of a mesh file, for grid2mesh. */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../lib/base/vec3.h"
#include "../../lib/grid/detail.h"
#include "../../lib/grid/gridmesh.h"
#include "../../lib/grid/gridpoint.h"
#include "../../lib/mesh/channel.h"
#include "../../lib/mesh/filled.h"
#include "../../lib/meshfile/facts.h"
#include "../../lib/meshfile/meshfile.h"
#include "../shared/chartof.h"
#include "../shared/load.h"
#include "../shared/place.h"
#include "gridfile.h"

void
gridfile_read_mesh(const char *path, int offsets, int keep_filled, OnMesh *on)
{
	const double *uv;
	int p, none = 0, dropped;

	on->name = cmd_name_of(path);
	on->offsets = offsets < 0 ? OFFSETS_KEEP : offsets;
	load_soup(path, MESHFILE_UV | MESHFILE_FIELDS, &on->s);
	if ((dropped = keep_filled ? 0 : filled_drop(&on->s)) < 0)
		die("%s: %s", on->name, on->s.err);
	if (dropped)
		note("%s: %d face%s that fill%s holes left out (--filled=keep keeps them)", on->name, dropped,
		    dropped == 1 ? "" : "s", dropped == 1 ? "s" : "");
	uv = channel_values(&on->s.channels, MESH_UV);
	for (p = 0; p < on->s.nv; p++)
		none += uv[2*(size_t)p] == -1 && uv[2*(size_t)p+1] == -1;
	if (none)
		note("%s: %d %s without (u,v) %s in place", on->name, none,
		    none == 1 ? "vertex" : "vertices", none == 1 ? "stays" : "stay");
	if (offsets >= 0 && offsets != OFFSETS_DROP && !channel_find(&on->s.channels, MESH_OFFSET))
		note("%s: no offsets, so --detail changes nothing", on->name);
}

/* The metadata that say in which space and unit the coordinates are, as facts of a mesh file, malloc'd. */
static char *
facts_of(const Lhg *g)
{
	char *facts = cmd_alloc(FACTS_MOST, 1), key[FACT_KEY], value[FACT_VALUE];
	const char *line = g->meta;
	size_t n = 0, k;

	for (*facts = '\0'; line && *line; line += k + (line[k] == '\n')) {
		k = strcspn(line, "\n");
		if (!fact_next(line, key, value) || !fact_is(key) || n + strlen(key) + strlen(value) + 3 > FACTS_MOST)
			continue;
		n += (size_t)snprintf(facts + n, FACTS_MOST - n, "%s %s\n", key, value);
	}
	return facts;
}

/* Sets s to the mesh of a grid.  single: coordinates will be written as floats, to a file of that kind. */
static void
mesh_of_grid(const CmdInput *in, const Lhg *g, const double *const phi[3], int single, const char *kind,
	Soup *s)
{
	Mesh m;
	int left = 0, e = mesh_from_grid(&m, chart_of(g), phi);
	size_t k;

	for (k = 0; !e && single && k < 3*(size_t)m.nv; k++)
		if (fabs(m.xyz[k]) > FLT_MAX)
			die("%s: a coordinate is too large for %s", in->name, kind);
	if (!e)
		e = gridmesh_part(&m, chart_of(g), single, &left);
	if (e)
		die("%s: no memory for a mesh of %d x %d vertices", in->name, g->nu, g->nv);
	if (left)
		note("%s: %d faces without area, or nodes at one place: cells smaller than %s can hold", in->name,
		    left, kind);
	*s = (Soup){ .nv = m.nv, .nf = m.nf, .xyz = m.xyz, .idx = m.tri };
}

/* The metadatum waves of a filtered grid: the wave number up to which the filter kept detail, in
 * cycles per width of the rectangle; 0 if the grid was not filtered. */
static double
waves_of(const CmdInput *in, const Lhg *g)
{
	char value[LHG_KEYLEN];
	double waves;
	char *end;

	if (!lhg_getmeta(g, "waves", value, sizeof value)) {
		note("%s: no metadatum waves, so no filter is known: --detail=smooth keeps all", in->name);
		return 0;
	}
	waves = strtod(value, &end);
	if (*end || !(waves > 0 && isfinite(waves)))
		die("%s: the metadatum waves is '%s', not a positive number", in->name, value);
	return waves;
}

/* Copies the offsets to the channel MESH_OFFSET of s.  If waves > 0, an offset of length L, in widths
 * of the rectangle, is multiplied by 1 - exp(-(waves L)^2).  So offsets much shorter than the
 * shortest wave, 1/waves, nearly vanish, and those much longer remain. */
static void
add_offsets(const OnMesh *on, double waves, const double *o, Soup *s)
{
	double *to = channel_add(&s->channels, MESH_OFFSET, DETAIL_SIZE, (size_t)s->nv), length, share;
	int c, p;

	if (!to)
		die("%s: no memory for the offsets of %d vertices", on->name, s->nv);
	memcpy(to, o, DETAIL_SIZE*(size_t)s->nv*sizeof *to);
	for (p = 0; waves > 0 && p < s->nv; p++, to += DETAIL_SIZE) {
		length = waves*norm3(to);
		share = -expm1(-length*length);
		for (c = 0; c < 3; c++)
			to[c] *= share;
	}
}

/* Moves the vertices of s by its offsets, each in the frame of the grid at the vertex's (u,v). */
static void
offset_vertices(const OnMesh *on, Chart g, const double *const phi[3], const double *uv, Soup *s)
{
	const double *o = channel_values(&s->channels, MESH_OFFSET);
	const double T = on->s.T > 0 ? on->s.T : g.T;
	Detail d;
	int p;

	if (detail_init(&d, g, phi))
		die("%s: no memory for the frames of %d x %d nodes", on->name, g.nu, g.nv);
	for (p = 0; p < s->nv; p++, uv += 2, o += DETAIL_SIZE) {
		double *x = s->xyz + 3*(size_t)p;

		if (uv[0] == -1 && uv[1] == -1)
			continue;
		detail_vertex(&d, T, uv[0], uv[1], o, x);
		if (!isfinite(x[0]) || !isfinite(x[1]) || !isfinite(x[2]))
			die("%s: vertex %d has an offset that is too large", on->name, p);
	}
	detail_free(&d);
}

/* Copies the numbers that the vertices have in another file, and other properties. */
static void
copy_fields(const OnMesh *on, Soup *s)
{
	const Channels *c = &on->s.channels;
	double *to;
	int k;

	for (k = 0; k < c->n; k++) {
		const Channel *from = &c->channel[k];

		if (strcmp(from->name, MESH_UV) == 0 || strcmp(from->name, MESH_OFFSET) == 0)
			continue;
		if (!(to = channel_add(&s->channels, from->name, from->n, (size_t)s->nv)))
			die("%s: no memory for %s at %d vertices", on->name, from->name, s->nv);
		memcpy(to, from->f, (size_t)s->nv*(size_t)from->n*sizeof *to);
		channel_find(&s->channels, from->name)->type = from->type;
	}
}

/* Sets uv to the (u,v) of the vertices of `on` in the chart of g, or dies. */
static void
places(const CmdInput *in, const Lhg *g, const OnMesh *on, double *uv)
{
	const double *was = channel_values(&on->s.channels, MESH_UV);
	const ChartKind *kind = on->s.chart;
	const Chart chart = chart_of(g);
	int at;

	if (kind && kind != chart.kind)
		die("%s: (u,v) on a %s, %s is on a %s: mesh2rect --chart=%s --uv", on->name, kind->name, in->name,
		    chart.kind->name, chart.kind->name);
	if (gridpoint_uv(chart, on->s.T, on->s.nv, was, uv, &at))
		die("%s: vertex %d has (u,v) = (%g,%g), outside [0,1] x [0,%g]", on->name, at,
		    was[2*(size_t)at], was[2*(size_t)at+1], on->s.T > 0 ? on->s.T : g->T);
}

/* Sets s to the mesh of `on`, with its vertices moved to their (u,v) on the grid. */
static void
place_mesh(const CmdInput *in, const Lhg *g, const double *const phi[3], const OnMesh *on, Soup *s)
{
	const Chart chart = chart_of(g);
	const double *o = channel_values(&on->s.channels, MESH_OFFSET);
	double *uv;

	*s = on->s;
	s->T = g->T;
	s->chart = chart.kind;
	s->xyz = cmd_alloc((size_t)s->nv, 3*sizeof *s->xyz);
	memcpy(s->xyz, on->s.xyz, 3*(size_t)s->nv*sizeof *s->xyz);
	s->channels = (Channels){ 0 };
	if (!(uv = channel_add(&s->channels, MESH_UV, 2, (size_t)s->nv)))
		die("%s: no memory for the (u,v) of %d vertices", on->name, s->nv);
	copy_fields(on, s);
	places(in, g, on, uv);
	if (!o || on->offsets == OFFSETS_DROP) {
		gridpoint_vertices(chart, 3, phi, s->nv, uv, s->xyz);
		return;
	}
	add_offsets(on, on->offsets == OFFSETS_SMOOTH ? waves_of(in, g) : 0, o, s);
	offset_vertices(on, chart, phi, uv, s);
}

/* The positions of the nodes: x y z; or for fields, which are those of grids between grid2lh and lh2grid, the
 * place. */
static void
positions(const CmdInput *in, const Lhg *g, const Fields *fields, const double *phi[3])
{
	static const char *const name[3] = { "x", "y", "z" };
	int c, placed = fields->names && !lhg_find(g, "x") && lhg_find(g, PLACE[0]);

	for (c = 0; c < 3; c++)
		phi[c] = cmd_need(in, g, placed ? PLACE[c] : name[c], LHG_GRID);
}

void
gridfile_soup(const CmdInput *in, const Lhg *g, const OnMesh *on, const Fields *fields, int single,
	const char *kind, Soup *s)
{
	const double *phi[3];

	positions(in, g, fields, phi);
	if (on->name)
		place_mesh(in, g, phi, on, s);
	else
		mesh_of_grid(in, g, phi, single, kind, s);
	fields_add(in, g, fields, s->nv, channel_values(&s->channels, MESH_UV), &s->channels);
	s->facts = facts_of(g);
}

void
gridfile_soup_free(const OnMesh *on, Soup *s)
{
	if (!on->name)
		free(s->idx);           /* else it is that of the mesh */
	free(s->facts);
	free(s->xyz);
	channels_free(&s->channels);
}

void
gridfile_bytes(const CmdInput *in, const Lhg *g, const OnMesh *on, const Fields *fields,
	const MeshFormat *format, char **bytes, size_t *n)
{
	const char *name = on->name ? on->name : in->name;
	Soup s;

	gridfile_soup(in, g, on, fields, (format->can & MESHFORMAT_SINGLE) != 0, format->name, &s);
	switch (meshfile_write(&s, format, bytes, n)) {
	case 0: break;
	case MESH_EFACE: die("%s: %s has only triangles, a face of the mesh is none", name, format->name);
	case MESH_EVALUE: die("%s: a coordinate is too large for %s", name, format->name);
	default: die("%s: no memory for a mesh of %d vertices", name, s.nv);
	}
	gridfile_soup_free(on, &s);
}

void
gridfile_fields(const CmdInput *in, const Lhg *g, const OnMesh *on, const Fields *fields, const FieldFormat *format,
	Channels *c)
{
	double *uv = on->name ? cmd_alloc((size_t)on->s.nv, 2*sizeof *uv) : NULL;

	if (uv)
		places(in, g, on, uv);
	fields_add(in, g, fields, on->name ? on->s.nv : g->nu*g->nv, uv, c);
	if (format->most && c->n > format->most)
		misuse("--with=%s: a %s file holds one channel", fields->names, format->name);
	free(uv);
}

void
gridfile_field_bytes(const CmdInput *in, const Lhg *g, const OnMesh *on, const Fields *fields,
	const FieldFormat *format, char **bytes, size_t *n)
{
	int nv = on->name ? on->s.nv : g->nu*g->nv, nf = on->name ? on->s.nf : 2*chart_of(g).kind->cells(chart_of(g));
	Channels c = { 0 };

	gridfile_fields(in, g, on, fields, format, &c);
	if (fieldfile_write(&c, nv, nf, format, bytes, n))
		die("%s: no memory for %d vertices", in->name, nv);
	channels_free(&c);
}
