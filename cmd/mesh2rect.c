/* mesh2rect - map a mesh conformally onto a rectangle, a sock or a pillow and sample it on a grid */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../lib/map/conformal.h"
#include "../lib/map/intrinsicmap.h"
#include "../lib/mesh/boundarysplit.h"
#include "../lib/mesh/channel.h"
#include "../lib/mesh/disk.h"
#include "shared/claim.h"
#include "shared/cmd.h"
#include "shared/formats.h"
#include "shared/load.h"
#include "mesh2rect/chartopt.h"
#include "mesh2rect/coneopt.h"
#include "mesh2rect/corneropt.h"
#include "mesh2rect/likeopt.h"
#include "mesh2rect/likepillow.h"
#include "mesh2rect/likesock.h"
#include "mesh2rect/loss.h"
#include "mesh2rect/quality.h"
#include "mesh2rect/uvopt.h"
#include "mesh2rect/withopt.h"

static const char text[] =
"usage: mesh2rect [OPTIONS] [MESH] >grid.lhg\n"
"Maps a triangle mesh conformally onto a chart [0,1] x [0,T] and samples it there on a grid.\n"
"The mesh is a topological disk, in one piece with one boundary and no handle, or a closed\n"
"surface without handles, and its triangles have areas.  MESH (none or -: stdin), also gzipped, is by its content\n"
"{formats}.\n"
"Writes channels x y z, and metadata vertices faces corners certificate solved turned overlaid\n"
"polished area kept farthest, like with --like, cones chi2 of a sock or a pillow, space c_ras unit\n"
"source if MESH has them.\n"
"      --chart=rectangle|sock|pillow|auto  the sock, for heads, ears and limbs: periodic in u, folded at\n"
"                     v = 0, boundary at v = T without corners; the pillow, for closed surfaces: folded\n"
"                     at v = T, too; auto: the sock where it is clearly better [rectangle, or pillow]\n"
"      --cones=I,J    the ends of the fold of a sock, inner vertices given as for --corners: the\n"
"                     tips of limbs [auto: where cells become most equal]\n"
"      --cones=I,J,K  the same on a pillow, and (1/2,T); the fourth, (0,T), follows [auto]\n"
"      --force        a pillow even if chi2 is above 100\n"
"  -n, --cells=N|NxM  cells along u, or along u and v, 4..32767 each; else N means as many nodes as on\n"
"                     the rectangle, NxM cells round it and along it [256]\n"
"      --cells=auto   the fewest of 32 48 64 96 128 .. that keep 99 % of the area of the mesh\n"
"      --max-cells=N  at most N cells along u with --cells=auto, 4..32767 [1024]\n"
"      --max-loss=SHARE  refuse a grid that loses more than SHARE of the area, 0..1 [0.5]\n"
"  -c, --corners=I,J,K,L  boundary vertices, numbered from 0 as in the file, that become\n"
"                     the corners (0,0) (1,0) (1,T) (0,T), counterclockwise\n"
"      --corners='x,y,z;x,y,z;x,y,z;x,y,z'  the boundary vertices nearest to these points\n"
"      --corners=FILE four numbers, or four points, one on each line, from FILE\n"
"      --corners=auto four clear corners of the boundary, else equal arc lengths [auto]\n"
"      --like=GRID    corners as on GRID: the boundary curves, by arc length, are fitted by motion and\n"
"                     shift; a sock or pillow gets GRID's numbers of nodes, a sock its order of cones,\n"
"                     a pillow T and cones by fit\n"
"      --like-reversed  with --like: reverse the normal of the mesh if the curves are closer then\n"
"      --flip         reverse the normal of the surface\n"
"      --tolerance=X  split the facets where the error of the map is largest until its\n"
"                     certificate sqrt(E(u) E(v/T)) - 1, E the Dirichlet energy, is at most X,\n"
"                     0..1; if it is not reached, this is noted [1e-3]\n"
"      --split=N      finally split every facet into four, N times; the map is then of quadratic "
"elements on the mesh before the last of these splits, 0..8 [1]\n"
"      --max-vertices=N  --tolerance and --split stop at about N vertices, 0..100000000 [300000]\n"
"      --surface=smooth|facets  between the vertices the surface is C1 and cubic\n"
"                     (Clough-Tocher over the chart) or flat [smooth]; with smooth it is\n"
"                     flat near triangles that straight edges in the chart turn over\n"
"      --polish=N     at most N rounds that map the grid by its own metric, each kept only if\n"
"                     the grid becomes more conformal, 0..100 [12]\n"
"      --with=FILE[,FILE..]  also numbers at the vertices of MESH, as channels: FreeSurfer's curv, sulc.., "
"GIFTI .shape.gii, PLY's colours, quality..; one for each vertex of MESH, or of what mesh2disk made it of\n"
"      --uv=FILE      write the mesh, with its (u,v) and offsets from the grid, to FILE {uv ends}:\n"
"                     for textures, and grid2mesh --on; vertices of no face get -1,-1;\n"
"                     no triangle is turned over, else noted; FILE is neither MESH nor output\n"
CMD_USAGE
"Example: mesh2rect --uv=face-uv.ply face.ply | grid2lh -o face.lhg\n";

enum { FLIP = 256, CHART, CONES, FORCE, WITH, SPLIT, TOLERANCE, MOST, SURFACE, POLISH, LIKE, REVERSED, MAX_CELLS,
	UV = CMD_UNRECORDED, MAX_LOSS };

static const struct option longopt[] = {
	{ "cells",        required_argument, NULL, 'n' },
	{ "chart",        required_argument, NULL, CHART },
	{ "cones",        required_argument, NULL, CONES },
	{ "force",        no_argument,       NULL, FORCE },
	{ "corners",      required_argument, NULL, 'c' },
	{ "like",         required_argument, NULL, LIKE },
	{ "like-reversed", no_argument,      NULL, REVERSED },
	{ "flip",         no_argument,       NULL, FLIP },
	{ "split",        required_argument, NULL, SPLIT },
	{ "tolerance",    required_argument, NULL, TOLERANCE },
	{ "max-vertices", required_argument, NULL, MOST },
	{ "surface",      required_argument, NULL, SURFACE },
	{ "polish",       required_argument, NULL, POLISH },
	{ "max-cells",    required_argument, NULL, MAX_CELLS },
	{ "max-loss",     required_argument, NULL, MAX_LOSS },
	{ "uv",           required_argument, NULL, UV },
	{ "with",         required_argument, NULL, WITH },
	CMD_LONGOPT
};

/* Memory in bytes, a little more than was measured: for each vertex of the map, and the part of it
 * that is kept while the grid is made; for each crossing of the overlay; for each node of the grid,
 * without and with polishing. */
enum { PER_VERTEX = 1500, KEPT = 500, PER_CROSSING = 250, PER_NODE = 8*13, PER_POLISHED = 8*46 };

/* Dies if memory is too small for the mesh and the grid.  Prints a note if it may be too small for
 * the vertices that refinement adds, whose number is not known in advance. */
static void
claim_map(const char *name, const Disk *d, Chart g, const ConformalOptions *o)
{
	double vertices = d->m.nv, nodes = (double)g.nu*g.nv, many = (o->most + 1.0)*(o->most + 1.0);
	int i;

	for (i = 0; i < o->map.split && 4*vertices <= o->map.most; i++)
		vertices *= 4;
	claim(name, "the map", vertices, PER_VERTEX);
	claim(name, "the grid", 1, KEPT*vertices + nodes*(o->polish ? PER_POLISHED : PER_NODE));
	if (o->keep > 0)
		claim_possible(name, "the grid", 1, KEPT*vertices + many*(o->polish ? PER_POLISHED : PER_NODE));
	if (o->map.tolerance < 1 && o->map.most > vertices)
		claim_possible(name, "the map", o->map.most, PER_VERTEX + INTRINSICMAP_CROSSINGS*PER_CROSSING);
}

/* If the boundary has only three vertices, splits an edge, since four corners are needed. */
static void
add_corner(const char *name, Disk *d)
{
	if (d->nb > 3 || d->nb == 0)
		return;
	if (boundary_split(d))
		die("no memory");
	note("%s: the boundary has three vertices: the middle of its longest edge is added", name);
}

/* Chooses the corners; returns the distance of the boundary from that of --like, or -1. */
static double
choose_corners(const char *corners, const char *like, int reversed, Disk *d, int corner[4])
{
	if (d->nb == 0)
		return -1;
	if (like)
		return opt_like(like, reversed, d, corner);
	opt_corners(corners, d, corner);
	return -1;
}

/* Dies as no map was found at vertex v, or at one that was added if v is -1. */
static void
too_thin(const Disk *d, int v)
{
	const double *x = d->m.xyz + 3*(size_t)(v < 0 ? 0 : v);

	if (v < 0 || d->file[v] < 0)
		die("triangles too thin to be mapped; mesh2disk takes out those without area");
	die("triangles too thin to be mapped at vertex %d (%g %g %g); mesh2disk takes out those without area",
	    d->file[v], x[0], x[1], x[2]);
}

static void
map_disk(const Disk *d, const int corner[4], Chart g, const ConformalOptions *options, Conformal *c)
{
	SpdReport report = { 0, 0 };

	cmd_progress("mapping %d vertices", d->m.nv);
	switch (d->nb ? conformal_grid(d, corner, g, options, c, &report) : conformal_closed(d, g, options, c, &report)) {
	case 0: break;
	case SPD_ENOMEM: die("no memory: the factor of %d vertices needs %.0f bytes", d->m.nv, report.bytes);
	case CONFORMAL_ECOARSE:
		die("triangles of the mesh are too large on the sphere: a larger --split, a smaller --tolerance%s",
		    options->cone[0] < 0 ? "" : ", or other --cones");
	case CONFORMAL_ECHI2:
		if (options->like.phi[0] && options->cone[0] < 0)
			die("chi^2 %.3g is above %g: nearly all nodes lie on a small part of the surface, so it is too unlike that "
			    "of --like: --cones, or --force", c->chi2[1], options->chi2);
		die("chi^2 %.3g is above %g: more than four long limbs, or cones away from their tips, so nearly all "
		    "nodes lie on a small part of the surface: other --cones, or --force", c->chi2[1], options->chi2);
	case CONFORMAL_ETURNED:
		die("the surface is so long, or a limb is, that its tip is lost in rounding on the sphere: cut it, or open it "
		    "(mesh2disk --open=auto) for --chart=sock");
	case CONFORMAL_ECONES:
		if (options->like.phi[0] && options->cone[0] < 0)
			die("no position on the surface of --like: one of them has no area, or limbs too long");
		if (d->nb == 0 && options->cone[0] < 0)
			die("the surface is so long, or its limbs are, that points cannot be told apart on the sphere: cut it");
		if (d->nb == 0)
			die("the three cones cannot be told apart on the sphere: other --cones");
		if (options->cone[0] < 0)
			die("no two inner vertices (of %d) can be told apart in the chart, so no cones: --chart=rectangle",
			    d->m.nv - d->nb);
		die("the two cones cannot be told apart in the chart: other --cones, or --chart=rectangle");
	case SPD_ELARGE: die("%d vertices are more than the solver can number", d->m.nv);
	default: too_thin(d, report.column);
	}
	if (!(c->grid.g.T > 0 && c->grid.g.T < HUGE_VAL))
		die("the map has no modulus: triangles too thin");
}

/* Sets out to the grid, with channels x y z. */
static void
begin_output(Lhg *out, const Grid *grid)
{
	static const char *const name[3] = { "x", "y", "z" };
	int k;

	lhg_init(out, grid->g.nu, grid->g.nv, grid->g.T);
	out->chart = lhg_chart(grid->g.kind->name);
	for (k = 0; k < 3; k++)
		memcpy(cmd_add(out, name[k], "length", LHG_GRID, 0), grid->phi[k],
		    (size_t)grid->g.nu*grid->g.nv*sizeof(double));
}

/* Frees all of s but the facts. */
static void
keep_facts(Soup *s)
{
	char *facts = s->facts;

	s->facts = NULL;
	soup_free(s);
	s->facts = facts;
}

/* What the command line asks for. */
typedef struct Request {
	ConformalOptions options;
	const char *corners, *cones, *like, *uv, *with;
	Chart  g;
	int    kind, flip, reversed;
	double most_lost;
} Request;

static void
read_options(int argc, char *argv[], Request *r)
{
	int opt;

	*r = (Request){ .options = { { 1e-3, 1, 300000 }, SAMPLER_SMOOTH, 12, 0, 1024, 0, NULL, { -1, -1, -1 }, 0, 1, 100,
	        { .g = { 0, 0, 0, NULL } } },
	    .g = { 257, 257, 1, &CHART_RECTANGLE }, .kind = CHARTOPT_UNSET, .most_lost = 0.5 };
	while ((opt = cmd_getopt(argc, argv, "n:c:", longopt)) != -1)
		switch (opt) {
		case 'n': opt_cells(optarg, &r->g, &r->options); break;
		case CHART: r->kind = opt_word(optarg, "rectangle\0sock\0pillow\0auto\0", "chart"); break;
		case CONES: r->cones = optarg; break;
		case FORCE: r->options.chi2 = 0; break;
		case 'c': r->corners = optarg; break;
		case LIKE: r->like = optarg; break;
		case REVERSED: r->reversed = 1; break;
		case FLIP: r->flip = 1; break;
		case TOLERANCE: r->options.map.tolerance = opt_double(optarg, 0, 1, "tolerance"); break;
		case SPLIT: r->options.map.split = opt_long(optarg, 0, 8, "split"); break;
		case MOST: r->options.map.most = opt_long(optarg, 0, 100000000, "max-vertices"); break;
		case SURFACE: r->options.surface = opt_word(optarg, "facets\0smooth\0", "surface"); break;
		case POLISH: r->options.polish = opt_long(optarg, 0, 100, "polish"); break;
		case MAX_CELLS: r->options.most = opt_long(optarg, 4, LHG_MAXN - 1, "max-cells"); break;
		case MAX_LOSS: r->most_lost = opt_double(optarg, 0, 1, "max-loss"); break;
		case UV: r->uv = optarg; break;
		case WITH: r->with = optarg; break;
		}
}

/* What --like has to do on a sock or a pillow once there is a map; returns the distance of the surfaces or their boundaries. */
static double
finish_like(const Request *r, int vertices, LikePillow *like, Conformal *c)
{
	if (!r->options.like.phi[0])
		return likesock_turn(r->like, vertices, c);
	likepillow_report(like, c);
	lhg_free(&like->g);
	return c->apart[0];
}

int
main(int argc, char *argv[])
{
	int corner[4], noted;
	const char *name;
	double apart;
	Request r;
	LikePillow like;
	ChartOptions given;
	Chart g;
	Channels own;
	Conformal c;
	Soup s;
	Disk d;
	Lhg out;
	static char usage[FORMATS_USAGE];

	cmd_begin("mesh2rect", formats_usage(text, usage, sizeof usage));
	read_options(argc, argv, &r);
	cmd_operands(argc, argv, 0, 1);
	name = cmd_name_of(argv[optind]);
	given = (ChartOptions){ r.kind, r.corners, r.cones, r.like, r.reversed };
	g = chartopt_before(&given, r.g, &r.options);
	if (r.uv)
		opt_uv(r.uv, argv[optind]);
	cmd_binary_output();
	load_soup(argv[optind], MESHFILE_LOOSE | (r.uv ? MESHFILE_FIELDS : 0), &s);
	uv_set_aside(&s, &own);
	if (r.with)
		with_read(r.with, &s);
	load_disk_or_closed(name, &s, &d);
	g = chartopt_of(name, &d, &given, g, &r.options);
	if (r.like && g.kind->closed)
		likepillow_read(r.like, name, &like, &g, &r.options);
	if (!r.uv)
		keep_facts(&s);
	if (r.flip)
		disk_flip(&d);
	add_corner(name, &d);
	apart = choose_corners(r.corners, g.kind == &CHART_SOCK ? NULL : r.like, r.reversed, &d, corner);
	opt_cones(r.cones, &d, r.options.cone);
	claim_map(name, &d, g, &r.options);
	if (r.with)
		with_fields(&d, &r.options);
	map_disk(&d, corner, g, &r.options, &c);
	if (r.like && g.kind->joined[1][0])
		apart = finish_like(&r, d.m.nv, &like, &c);

	begin_output(&out, &c.grid);
	if (r.with)
		with_write(&d, &c, &out);
	quality_meta(&out, &d, d.nb ? corner : NULL, apart, &c);
	cones_meta(&out, &d, &c);
	quality_facts(&out, s.facts);
	cones_chi2(name, &d, &c);
	noted = loss_report(&out, name, r.most_lost, r.like, &d, &c);
	cones_note(name, &c, noted);
	quality_notes(name, r.uv, &d, &r.options, &c);
	if (r.uv)
		uv_write(r.uv, &s, &own, &d, c.u, c.v, c.grid.g, (const double *const *)c.grid.phi);
	cmd_write(&out);

	channels_free(&own);
	free((void *)r.options.field);
	soup_free(&s);
	lhg_free(&out);
	conformal_free(&c);
	disk_free(&d);
	return cmd_end();
}
