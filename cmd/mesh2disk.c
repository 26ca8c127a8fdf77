/* mesh2disk - a disk, or a closed surface, from any mesh */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../lib/mend/mend.h"
#include "../lib/meshfile/meshfile.h"
#include "mesh2disk/check.h"
#include "mesh2disk/notes.h"
#include "mesh2disk/points.h"
#include "shared/claim.h"
#include "shared/cmd.h"
#include "shared/formats.h"
#include "shared/load.h"

static const char text[] =
"usage: mesh2disk [OPTIONS] [MESH] >disk.ply\n"
"Makes a disk, as mesh2rect needs it, of any surface mesh, and says in one line each what it\n"
"did: on stderr and in comments of the output.  MESH is {formats}, recognised by its\n"
"content, also gzipped; - or nothing: stdin.  In this order:\n"
"drops vertices of no face, faces at vertices that are not finite, faces said twice; welds\n"
"boundary vertices at one place; parts edges of more than two faces and pinched vertices,\n"
"where the larger parts stay together; keeps the largest component; turns faces to agree;\n"
"takes out faces without area; fills holes.  Writes PLY, or by -o {ends}.\n"
"Vertices keep position and order; in PLY each has its number in MESH (property source; -1:\n"
"made here), and faces that fill holes are marked (property filled).  The numbers at the vertices\n"
"of a PLY (colours, quality, labels, normals ..) go along with their types; vertices made here\n"
"have the mean of their neighbours', or for whole numbers, but colours, those of the nearest one.\n"
"Lists and numbers of faces are left out, with a note.\n"
"      --check        write no mesh, but a report of all that is wrong with MESH, and of what\n"
"                     the options would do about it\n"
"      --json         the report of --check as one JSON object\n"
"      --points       make faces of points without faces (advancing front), and say of what radius\n"
"      --weld=DIST|auto|none  boundary vertices within DIST become one; auto: within a\n"
"                     millionth of the diagonal of the bounding box [0: at equal positions]\n"
"      --components=largest|N|all  keep the largest, or the N largest, by area [largest]\n"
"      --holes=fill|keep|all  fill all loops but the longest of each component; fill none;\n"
"                     fill the longest, too, so that the surface is closed [fill]\n"
"      --max-hole=SHARE  fill loops of at most this share of the length of all, 0..1 [1]\n"
"      --fill=flat|C1|C2  the patches minimise area; or go on with the slope of the surface\n"
"                     round them; or with its curvature, too [C2]\n"
"      --handles=refuse|cut  cut each handle along a short cycle, and close both sides [refuse]\n"
"      --open=none|auto|X,Y,Z  a closed surface stays closed; is cut open between two points far\n"
"                     apart; from the vertex nearest to X,Y,Z to the one farthest from it [none]\n"
CMD_USAGE
"A map needs a long boundary: a cut from end to end serves, a small hole does not.  The vertices\n"
"of a cut lie at one place: --weld=none keeps such a mesh as it is.\n"
"Example: mesh2disk scan.ply | mesh2rect -o scan.grid\n";

enum { WELD = 256, COMPONENTS, HOLES, MAX_HOLE, FILL, HANDLES, OPEN, CHECK, JSON, POINTS };

static const struct option longopt[] = {
	{ "points",     no_argument,       NULL, POINTS },
	{ "weld",       required_argument, NULL, WELD },
	{ "components", required_argument, NULL, COMPONENTS },
	{ "holes",      required_argument, NULL, HOLES },
	{ "max-hole",   required_argument, NULL, MAX_HOLE },
	{ "fill",       required_argument, NULL, FILL },
	{ "handles",    required_argument, NULL, HANDLES },
	{ "open",       required_argument, NULL, OPEN },
	{ "check",      no_argument,       NULL, CHECK },
	{ "json",       no_argument,       NULL, JSON },
	CMD_LONGOPT
};

/* Memory in bytes for each face, a little more than was measured. */
enum { PER_FACE = 600, PER_NUMBER = 8 };      /* and for each property that goes along */

static double
opt_weld(const char *s)
{
	if (strcmp(s, "auto") == 0)
		return MEND_WELD_AUTO;
	if (strcmp(s, "none") == 0)
		return MEND_WELD_NONE;
	return opt_double(s, 0, 1e60, "weld");
}

static int
opt_components(const char *s)
{
	if (strcmp(s, "largest") == 0)
		return 1;
	return strcmp(s, "all") == 0 ? 0 : (int)opt_long(s, 1, 1000000000, "components");
}

static void
opt_holes(const char *s, MendOptions *o)
{
	const int what = opt_word(s, "all\0fill\0keep\0", "holes");

	o->fill_all = what == 0;
	o->keep_holes = what == 2;
}

static void
opt_open(const char *s, MendOptions *o)
{
	char end;

	o->open = strcmp(s, "none") == 0 ? MEND_CLOSED : strcmp(s, "auto") == 0 ? MEND_OPEN_AUTO : MEND_OPEN_AT;
	if (o->open != MEND_OPEN_AT)
		return;
	if (sscanf(s, "%lf,%lf,%lf%c", &o->at[0], &o->at[1], &o->at[2], &end) != 3 ||
	    !isfinite(o->at[0]) || !isfinite(o->at[1]) || !isfinite(o->at[2]))
		misuse("--open=%s: need none, auto or X,Y,Z", s);
}

static const MeshFormat *
output_format(void)
{
	const char *out = cmd_output();
	const MeshFormat *format = meshformat_of(out ? out : "out.ply");
	char list[MESHFORMAT_LIST];

	if (!format)
		misuse("--output=%s: need a name that ends in %s", out, meshformat_ends(MESHFORMAT_WRITE, list));
	return format;
}

/* Writes the mesh, with the notes as comments. */
static void
write_mesh(Soup *out, const MeshFormat *format, const char *remarks)
{
	char *bytes;
	size_t n;

	out->remarks = remarks;
	switch (meshfile_write(out, format, &bytes, &n)) {
	case 0: break;
	case MESH_EVALUE: die("a coordinate is too large for %s", format->name);
	default: die("no memory for a mesh of %d vertices", out->nv);
	}
	cmd_write_bytes(NULL, bytes, n);
	free(bytes);
}

static void
write_report(const char *name, const Soup *s, const Soup *out, const MendReport *r, const char *refusal, int json)
{
	CmdText t;

	cmd_text_open(&t);
	(json ? check_json : check_text)(t.f, name, s, out, r, refusal);
	cmd_text_close(&t);
	cmd_write_bytes(NULL, t.bytes, t.n);
	free(t.bytes);
}

int
main(int argc, char *argv[])
{
	static char usage[FORMATS_USAGE];
	const MeshFormat *format = NULL;
	MendOptions o = MEND_DEFAULTS;
	int opt, json = 0, points = 0, e;
	MendReport r;
	const char *name;
	char *remarks;
	Soup s, out;

	cmd_begin("mesh2disk", formats_usage(text, usage, sizeof usage));
	while ((opt = cmd_getopt(argc, argv, "", longopt)) != -1)
		switch (opt) {
		case WELD: o.weld = opt_weld(optarg); break;
		case COMPONENTS: o.components = opt_components(optarg); break;
		case HOLES: opt_holes(optarg, &o); break;
		case MAX_HOLE: o.max_hole = opt_double(optarg, 0, 1, "max-hole"); break;
		case FILL: o.fill = opt_word(optarg, "flat\0C1\0C2\0", "fill"); break;
		case HANDLES: o.cut_handles = opt_word(optarg, "refuse\0cut\0", "handles"); break;
		case OPEN: opt_open(optarg, &o); break;
		case CHECK: o.check = 1; break;
		case JSON: json = 1; break;
		case POINTS: points = 1; break;
		}
	cmd_operands(argc, argv, 0, 1);
	if (json && !o.check)
		misuse("--json needs --check");
	if (!o.check) {
		format = output_format();
		cmd_binary_output();
	}
	name = cmd_name_of(argv[optind]);
	load_soup(argv[optind], MESHFILE_LOOSE | MESHFILE_FIELDS | MESHFILE_NORMALS, &s);
	points_to_faces(name, points, &s);
	load_range(name, &s);
	claim(name, "the mending", s.nf, PER_FACE + PER_NUMBER*s.channels.n);
	e = mend(&out, &s, &o, &r);
	if (e == MESH_ENOMEM || (e && !o.check))
		die("%s: %s", name, out.err);
	out.facts = s.facts;
	s.facts = NULL;

	if (o.check) {
		write_report(name, &s, &out, &r, e ? out.err : NULL, json);
	} else {
		remarks = notes(name, &s, &r, format);
		write_mesh(&out, format, remarks);
		free(remarks);
	}
	mend_report_free(&r);
	soup_free(&s);
	soup_free(&out);
	return cmd_end();
}
