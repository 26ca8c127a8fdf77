/* lhdiff - distances between two surfaces, and their self-intersections */
#include <string.h>

#include "shared/cmd.h"
#include "shared/formats.h"
#include "lhdiff/report.h"
#include "lhdiff/surface.h"

static const char text[] =
"usage: lhdiff [--json] [--hausdorff-error=E] [--no-hausdorff]\n"
"              [--no-self-intersections] A B\n"
"Compares surface B with A, the reference.  Each is a stream of grids with channels x y z,\n"
"or a mesh file ({formats});\n"
"- is stdin.  Prints lines \"name value\":\n"
"  area_a area_b      areas\n"
"  max mean           largest and mean distance of vertices with the same number; left out if\n"
"                     A and B do not have equally many vertices\n"
"  hausdorff          symmetric Hausdorff distance of the surfaces, faces included\n"
"  hausdorff_error    the true distance is hausdorff plus or minus this; surfaces that are\n"
"                     nearer than this may have it as hausdorff\n"
"  max_rel mean_rel hausdorff_rel   the same over the square root of the area of A\n"
"  self_intersections_a, _b   pairs of faces that meet where they are not joined\n"
"Streams of several grids (a morph, or scales) are compared grid by grid; if A is one surface,\n"
"each grid of B is compared with it.  The result is then a table with tabs between fields: a\n"
"line of names, then a line for each pair, which begins with its number (frame), from 1; - stands\n"
"for a value that is not defined.  Only one grid of each stream is in memory, and the values of\n"
"a single A are computed once.\n"
"Options:\n"
"      --json         one JSON object instead; in place of a table, one on each line\n"
"      --hausdorff-error=E  hausdorff_error over the square root of the area of A,\n"
"                     1e-7..1 [1e-3]; if the surfaces are closer than that, the time grows\n"
"                     as 1/E\n"
"      --no-hausdorff, --no-self-intersections   leave these out\n"
CMD_USAGE
"A mesh need not be a disk: what is not, is noted.  Faces without area are left out, and\n"
"self-intersections of what is not a manifold.  The exit code is 0 whatever the distance, 1 if\n"
"a surface cannot be read or has no area.\n"
"Example: lhdiff face.ply smooth.ply\n";

static const struct option longopt[] = {
	{ "json",                  no_argument,       NULL, 'J' },
	{ "hausdorff-error",       required_argument, NULL, 'e' },
	{ "no-hausdorff",          no_argument,       NULL, 'H' },
	{ "no-self-intersections", no_argument,       NULL, 'S' },
	CMD_LONGOPT
};

/* Replaces side by the next surface of s with its area and self-intersections.  Returns 0 at the
 * end. */
static int
next_side(const Compare *c, Surfaces *s, Side *side)
{
	mesh_free(&side->m);
	if (!surfaces_next(s, &side->m))
		return 0;
	compare_side(c, s->place, side);
	return 1;
}

/* Both streams must have equally many grids; dies as soon as they differ. */
static void
check_counts(const Surfaces *as, const Surfaces *bs)
{
	int m = as->in.s.frames, n = bs->in.s.frames;
	const Surfaces *fewer = surfaces_more(as) ? bs : as, *more = surfaces_more(as) ? as : bs;

	if (m > 1 && n > 1 && m != n)
		die("%s has %d grids, %s has %d", as->in.name, m, bs->in.name, n);
	if (surfaces_more(as) != surfaces_more(bs))
		die("%s has %ld %s, %s has more", fewer->in.name, fewer->count,
		    fewer->count == 1 ? "grid" : "grids", more->in.name);
}

static void
compare_all(const Compare *c, Surfaces *as, Surfaces *bs, int json)
{
	Side a = { .area = 0 }, b = { .area = 0 };
	double value[COMPARE_N];
	Report r;
	int one;

	next_side(c, as, &a);
	next_side(c, bs, &b);
	one = !surfaces_more(as);
	report_begin(&r, json, !one || surfaces_more(bs));
	do {
		if (!one)
			check_counts(as, bs);
		if (a.m.nv != b.m.nv && r.count == 0)
			note("%d and %d vertices: no max and mean", a.m.nv, b.m.nv);
		compare(c, &a, &b, value);
		report_add(&r, c, value);
		cmd_progress_share(r.count, bs->in.s.frames);
	} while (next_side(c, bs, &b) && (one || next_side(c, as, &a)));
	report_write(&r);
	mesh_free(&a.m);
}

int
main(int argc, char *argv[])
{
	Compare c = { 1e-3, 1, 1 };
	int opt, json = 0;
	Surfaces a, b;
	static char usage[FORMATS_USAGE];

	cmd_begin("lhdiff", formats_usage(text, usage, sizeof usage));
	while ((opt = cmd_getopt(argc, argv, "", longopt)) != -1)
		switch (opt) {
		case 'J': json = 1; break;
		case 'e': c.error = opt_double(optarg, 1e-7, 1, "hausdorff-error"); break;
		case 'H': c.far = 0; break;
		case 'S': c.cross = 0; break;
		}
	cmd_operands(argc, argv, 2, 2);
	if (strcmp(argv[optind], "-") == 0 && strcmp(argv[optind+1], "-") == 0)
		misuse("both A and B are stdin");
	surfaces_open(&a, argv[optind]);
	surfaces_open(&b, argv[optind+1]);

	compare_all(&c, &a, &b, json);
	return cmd_end();
}
