/* mesh2rect - map a mesh conformally onto a rectangle and sample it on a grid */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../lib/rectmap.h"
#include "../lib/sample.h"
#include "cmd.h"
#include "corneropt.h"
#include "load.h"

static const char text[] =
"usage: mesh2rect [-n N|NxM] [-c I,J,K,L | --corners=auto|FILE] [MESH] >grid.lhg\n"
"Maps a triangle mesh with one boundary (a topological disk: OFF, OBJ, PLY or STL, by\n"
"content; - or nothing: stdin) onto the rectangle [0,1] x [0,T] and samples it.\n"
"writes channels x y z, metadata vertices faces corners certificate turned\n"
"  -n, --cells=N|NxM  cells along u, or along u and v, 4..32767 each [256]\n"
"  -c, --corners=I,J,K,L  boundary vertices, from 0, that become the corners (0,0) (1,0)\n"
"                     (1,T) (0,T), in the order of the boundary, counterclockwise\n"
"      --corners=auto four clear corners of the boundary if it has them, else four\n"
"                     vertices at equal arc length from its lowest vertex number [auto]\n"
"      --corners=FILE the four numbers are in FILE\n"
CMD_USAGE
"Under -v: the modulus T, the certificate (0 for an exactly conformal map), the number\n"
"of triangles that the map turned over.\n";

static const struct option longopt[] = {
	{ "cells",   required_argument, NULL, 'n' },
	{ "corners", required_argument, NULL, 'c' },
	CMD_LONGOPT
};

/* "N" or "NxM" cells as numbers of nodes. */
static void
opt_cells(char *s, Chart *g)
{
	char *x = strchr(s, 'x'), *first = strdup(s);

	if (!first)
		die("no memory");
	if (x)
		first[x - s] = '\0';
	g->nu = 1 + opt_long(first, 4, LHG_MAXN - 1, "cells");
	g->nv = x ? 1 + opt_long(x + 1, 4, LHG_MAXN - 1, "cells") : g->nu;
	free(first);
}

static void
solve(const Disk *d, const int corner[4], double *u, double *v, double *T, double *certificate)
{
	SpdReport report;

	cmd_progress("mapping %d vertices", d->m.nv);
	switch (rectmap(d, corner, u, v, T, certificate, &report)) {
	case 0: break;
	case SPD_ENOMEM: die("no memory: the factor of %d vertices wants %.0f bytes", d->m.nv, report.bytes);
	case SPD_ELARGE: die("%d vertices are more than the solver can number", d->m.nv);
	default: die("the cotangent matrix is not positive definite at row %d: triangles too thin", report.column);
	}
	if (!(*T > 0 && *T < HUGE_VAL))
		die("the map has no modulus: triangles too thin");
}

static void
describe(Lhg *out, const Disk *d, const int corner[4], double certificate, int turned)
{
	const int *l = d->loop;

	cmd_meta(out, "vertices", "%d", d->m.nv);
	cmd_meta(out, "faces", "%d", d->m.nf);
	cmd_meta(out, "corners", "%d,%d,%d,%d", l[corner[0]], l[corner[1]], l[corner[2]], l[corner[3]]);
	cmd_meta(out, "certificate", "%.6g", certificate);
	cmd_meta(out, "turned", "%d", turned);
	detail("T %.6g, certificate %.3g, %d of %d triangles turned over", out->T, certificate, turned, d->m.nf);
}

static void
sample(const Disk *d, const int corner[4], const double *u, const double *v, Chart g, Lhg *out)
{
	double *phi[3];
	int at = 0;

	phi[0] = cmd_add(out, "x", "length", LHG_GRID, 0);
	phi[1] = cmd_add(out, "y", "length", LHG_GRID, 0);
	phi[2] = cmd_add(out, "z", "length", LHG_GRID, 0);
	switch (sample_disk(d, corner, u, v, g, phi, &at)) {
	case 0: break;
	case SAMPLE_ENOMEM: die("no memory: %d x %d nodes wanted", g.nu, g.nv);
	default: die("no triangle covers node (%d,%d)", at%g.nu, at/g.nu);
	}
}

int
main(int argc, char *argv[])
{
	double *u, *v, certificate;
	const char *corners = NULL;
	Chart g = { 257, 257, 1 };
	int opt, corner[4];
	Disk d;
	Lhg out;

	cmd_begin("mesh2rect", text);
	while ((opt = cmd_getopt(argc, argv, "n:c:", longopt)) != -1)
		switch (opt) {
		case 'n': opt_cells(optarg, &g); break;
		case 'c': corners = optarg; break;
		}
	cmd_operands(argc, argv, 0, 1);
	cmd_binary_output();

	load_disk(argv[optind], &d);
	opt_corners(corners, &d, corner);

	u = cmd_alloc(d.m.nv, sizeof *u);
	v = cmd_alloc(d.m.nv, sizeof *v);
	solve(&d, corner, u, v, &g.T, &certificate);

	lhg_init(&out, g.nu, g.nv, g.T);
	sample(&d, corner, u, v, g, &out);
	describe(&out, &d, corner, certificate, rectmap_flipped(&d.m, u, v));
	cmd_write(&out);

	lhg_free(&out);
	disk_free(&d);
	free(u);
	free(v);
	return cmd_end();
}
