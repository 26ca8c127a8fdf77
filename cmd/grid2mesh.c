/* grid2mesh - a gridded surface as a triangle mesh */
#include <stdlib.h>

#include "../lib/meshfile/meshformat.h"
#include "shared/cmd.h"
#include "shared/formats.h"
#include "shared/numbered.h"
#include "grid2mesh/gridfile.h"
#include "grid2mesh/keep.h"
#include "grid2mesh/scene.h"

static const char text[] =
"usage: grid2mesh [-o FILE] [--on=MESH] [--with=NAMES] [GRID] >mesh.off\n"
"Writes a gridded surface, channels x y z (--with: or place.x place.y place.z), as a triangle mesh:\n"
"a vertex for each node, row by row, and two triangles for each cell, split along its shorter\n"
"diagonal.  Normals point along x_u cross x_v.  Every face has area: where a cell is flat it is split along the other diagonal,\n"
"or its nodes are moved by a thousandth of a cell, for STL by what a float can tell apart.\n"
"In PLY and OBJ, comments hold the metadata space, c_ras, unit and source, if GRID has them.\n"
"      --on=MESH      write MESH instead, with each vertex moved to its (u,v) on the grid\n"
"                     (bicubic interpolation), and by its offset from there if MESH has\n"
"                     offsets; faces and the order of vertices are kept.\n"
"                     MESH is {uv formats} with (u,v), written by mesh2rect --uv.  v is scaled\n"
"                     if the grid has another height T; a vertex with (u,v) = (-1,-1) stays\n"
"                     in place.  If FILE is {uv formats} too, it has the (u,v); in PLY and VTP\n"
"                     also the other numbers of a PLY at its vertices\n"
"      --detail=keep|drop|smooth  offsets in full, so that detail finer than the grid and\n"
"                     limbs that it lost stay; none; or, for grids of lhfft, the less the\n"
"                     shorter they are against its shortest waves (metadatum waves) [keep]\n"
"      --filled=drop|keep  faces of MESH that mesh2disk marked as filling holes are left out, and\n"
"                     the vertices that only they have; or kept [drop]\n"
"      --keep=FILE    with --on: write FILE, the OBJ or PLY from which MESH was made, also by mesh2disk, with only its\n"
"                     vertices moved and normals computed again: texture coordinates, materials,\n"
"                     groups, colours, other properties, polygons and order stay as they are;\n"
"                     with --with, numbers alone at the vertices of FILE, a mesh of any format\n"
"      --with=NAMES   also write these channels of GRID, as lambda,H, at the vertices: as\n"
"                     properties of PLY and point data of VTP; or alone, to FILE that ends in\n"
"                     .shape.gii .func.gii (GIFTI) .curv .sulc .thickness (FreeSurfer, one channel);\n"
"                     NaN at a vertex without (u,v)\n"
"      --seconds=S    FILE.glb, glTF 2, takes all grids of a stream, the first as the mesh and the\n"
"                     others as morph targets of an animation of S seconds [4]; --with=H colours it\n"
"      --flip-sign    negate H.  With outward normals H is positive in a sulcus, as FreeSurfer's\n"
"                     curv; files of the HCP for Workbench count a sulcus negative\n"
"  -o, --output=FILE  write FILE, in the format that its name ends in, {ends}\n"
"                     [{stdout} to stdout].  For a stream of several grids the name must have a\n"
"                     number, as in frame-%03d.off, which counts from 1.  Each file is written\n"
"                     completely or not at all\n"
"      --no-history   accepted as by every command, without effect: meshes have no history\n"
CMD_USAGE_COMMON
"Example: grid2lh x.grid | lhfft --scale=6 | lh2grid | grid2mesh -o smooth.ply\n";

static const struct option longopt[] = {
	{ "on",     required_argument, NULL, 'O' },
	{ "detail", required_argument, NULL, 'd' },
	{ "filled", required_argument, NULL, 'f' },
	{ "keep",   required_argument, NULL, 'k' },
	{ "with",   required_argument, NULL, 'w' },
	{ "flip-sign", no_argument,    NULL, 'F' },
	{ "seconds", required_argument, NULL, 's' },
	CMD_LONGOPT
};

/* Exit 2 if mesh and grid are both stdin, or if the format does not keep the order of vertices. */
static void
check_on(const char *on, const char *grid, const MeshFormat *format)
{
	char list[MESHFORMAT_LIST];

	if (cmd_name_of(on) != on && cmd_name_of(grid) != grid)
		misuse("--on=%s: the grid is read from stdin", on);
	if (!(format->can & MESHFORMAT_SHARED))
		misuse("--on: %s does not keep the order of vertices: need a name that ends in %s", format->name,
		    meshformat_ends(MESHFORMAT_SHARED | MESHFORMAT_WRITE, list));
}

/* Exit 2 if there is no place for the fields, or none for a file of fields. */
static void
check_with(const Fields *f, const MeshFormat *format, const FieldFormat *alone)
{
	char list[FIELDFORMAT_LIST];

	if (alone && !f->names)
		misuse("--output: a %s file holds channels, need --with", alone->name);
	if (f->names && !alone && format && !(format->can & MESHFORMAT_FIELDS))
		misuse("--with: %s has no place for channels, .ply .vtp and %s have", format->name, fieldformat_ends(list));
	if (f->flip && !f->names)
		misuse("--flip-sign needs --with");
}

int
main(int argc, char *argv[])
{
	static char usage[FORMATS_USAGE];
	char path[4096], list[MESHFORMAT_LIST], ends[FIELDFORMAT_LIST], *bytes;
	const char *name, *on = NULL, *keep = NULL;
	OnMesh mesh = { 0 };
	Fields fields = { NULL, 0 };
	const FieldFormat *alone;
	Scene scene = { 0 };
	double seconds = 4;
	const MeshFormat *format;
	int many, opt, i = 0, offsets = -1, filled = -1;
	size_t n;
	CmdInput in;
	Lhg g;

	cmd_begin("grid2mesh", formats_usage(text, usage, sizeof usage));
	while ((opt = cmd_getopt(argc, argv, "", longopt)) != -1)
		switch (opt) {
		case 'O': on = optarg; break;
		case 'd': offsets = opt_word(optarg, "keep\0drop\0smooth\0", "detail"); break;
		case 'k': keep = optarg; break;
		case 'w': fields.names = optarg; break;
		case 'F': fields.flip = 1; break;
		case 's': seconds = opt_double(optarg, 1e-3, 1e6, "seconds"); break;
		case 'f': filled = opt_word(optarg, "drop\0keep\0", "filled"); break;
		}
	if ((offsets >= 0 || filled >= 0) && !on)
		misuse("--%s needs --on", offsets >= 0 ? "detail" : "filled");
	if (keep && !on)
		misuse("--keep needs --on");
	cmd_operands(argc, argv, 0, 1);
	name = cmd_output();
	alone = name ? fieldformat_of(name) : NULL;
	if (!(format = name ? meshformat_of(name) : meshformat(0)) && !alone && !scene_is(name))
		misuse("--output=%s: need a name that ends in %s", name, meshformat_ends(MESHFORMAT_WRITE, list));
	if (keep && !alone && (!format || !(format->can & MESHFORMAT_UV)))
		misuse("--keep: need -o FILE that ends in %s", meshformat_ends(MESHFORMAT_UV, list));
	if (keep && !alone && fields.names)
		misuse("--keep with --with writes numbers alone: need -o FILE that ends in %s", fieldformat_ends(ends));
	check_with(&fields, scene_is(name) ? NULL : format, alone);
	many = scene_is(name) || numbered(name);
	if (on && !alone && !scene_is(name))
		check_on(on, argv[optind], format);

	cmd_open(&in, argv[optind]);
	while (cmd_read(&in, &g)) {
		if (!many && (g.frames > 1 || in.s.ahead))
			die("%s: holds several grids, one for each file: need -o NAME-%%03d.off", in.name);
		if (on && i == 0)
			gridfile_read_mesh(on, offsets, filled > 0, &mesh); /* once mesh2rect has written it */
		if (scene_is(name)) {
			scene_add(&scene, &in, &g, &mesh, &fields);
			i++;
			lhg_free(&g);
			continue;
		}
		if (keep && alone)
			keep_field_bytes(&in, &g, &mesh, keep, &fields, alone, &bytes, &n);
		else if (keep)
			keep_bytes(&in, &g, &mesh, keep, format, &bytes, &n);
		else if (alone)
			gridfile_field_bytes(&in, &g, &mesh, &fields, alone, &bytes, &n);
		else
			gridfile_bytes(&in, &g, &mesh, &fields, format, &bytes, &n);
		cmd_write_bytes(numbered_name(name, ++i, path, sizeof path), bytes, n);
		free(bytes);
		lhg_free(&g);
	}
	if (scene_is(name)) {
		scene_bytes(&scene, &in, seconds, &bytes, &n);
		cmd_write_bytes(name, bytes, n);
		free(bytes);
	}
	soup_free(&mesh.s);
	return cmd_end();
}
