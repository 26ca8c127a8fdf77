/* lhwarp - B on the chart of A, so that corresponding places meet */
#include "lhwarp/sampled.h"

static const char text[] =
"usage: lhwarp [OPTIONS] A B >b-on-a.lhg\n"
"Writes B on the chart of A: finds a one-to-one map of A's rectangle onto B's under\n"
"which corresponding places meet, and samples B there.  Both are grids x y z on\n"
"rectangles, as mesh2rect writes them (- is stdin).  The result has A's size and\n"
"height T and is moved rigidly onto A.  B's other channels are sampled, too.\n"
"  -l, --landmarks=FILE  corresponding points (below)\n"
"      --normals      match the unit normals of the surfaces, and landmarks [yes]\n"
"      --no-normals   match landmarks only\n"
"      --max-mu=X     keep the largest |mu| of the map below X, 0.01..0.99; it is 0 where\n"
"                     the map is conformal [0.6]\n"
"  -s, --scale        first scale B about the origin to the area of A\n"
"      --uv-a=MESH    the mesh of A, {uv formats} with (u,v), written by mesh2rect\n"
"                     --uv: for landmarks by vertex number\n"
"      --uv-b=MESH    the mesh of B.  B is then sampled from it; without it, from its\n"
"                     grid, which should have more nodes than A: mesh2rect -n\n"
"      --force        warp even if no way to lay B onto A is clearly the best\n"
CMD_USAGE
"B's rectangle is tried in four ways, each turned by a quarter more.  One is taken\n"
"if its mismatch of the normals is at most 0.8 of the next best, or if landmarks\n"
"decide.  If two ways half a turn apart fit alike, as those of an oval face do, but\n"
"better than the others, that is taken which turns B less in space, by 45 degrees\n"
"or more.  Otherwise the surfaces are too unlike for an automatic map: exit 1.  Then\n"
"give landmarks, or morph without a map: lhinterp --scale --align --cap.\n"
"FILE has one landmark on each line: two vertex numbers, of --uv-a and --uv-b,\n"
"counted from 0; or u v on A and u v on B; or a point x y z on A and one on B.\n"
"# begins a comment.  Metadata: `warped', the mean and the largest |mu|;\n"
"`warp-normals', the mean square difference of the unit normals without and with\n"
"the map; `warp-landmarks', the mean distance of landmarks, in widths of the chart;\n"
"-v prints them.  On a warped grid H is not the mean curvature: continue with\n"
"grid2lh --residual.  Socks and pillows are refused.\n"
"Example: lhwarp a.lhg b.lhg | grid2lh --residual -o b-lh.lhg\n";

enum { NORMALS = 1, NO_NORMALS, MAX_MU, UV_A, UV_B, FORCE };

static const struct option longopt[] = {
	{ "landmarks",  required_argument, NULL, 'l' },
	{ "normals",    no_argument,       NULL, NORMALS },
	{ "no-normals", no_argument,       NULL, NO_NORMALS },
	{ "max-mu",     required_argument, NULL, MAX_MU },
	{ "scale",      no_argument,       NULL, 's' },
	{ "uv-a",       required_argument, NULL, UV_A },
	{ "uv-b",       required_argument, NULL, UV_B },
	{ "force",      no_argument,       NULL, FORCE },
	CMD_LONGOPT
};

static void
report(const Found *f)
{
	detail("|mu| mean %.3f, largest %.3f; weight of the distortion %.3g, beyond the bound %.3g", f->after.mu_mean,
	    f->after.mu_max, f->after.alpha, f->after.stiff);
	detail("normals differ by %.4g without the map, %.4g with it (mean square)", f->before.apart, f->after.apart);
	if (f->before.marks > 0)
		detail("landmarks %.2f %% of the width apart without the map, %.2f %% with it", 100*f->before.marks,
		    100*f->after.marks);
}

int
main(int argc, char *argv[])
{
	const char *landmarks = NULL, *uv[2] = { NULL, NULL };
	FindOptions o = { .normals = 1, .mumax = 0.6 };
	int opt, scale = 0;
	Marks marks;
	Side a, b;
	Found f;
	Lhg out;

	cmd_begin("lhwarp", text);
	while ((opt = cmd_getopt(argc, argv, "l:s", longopt)) != -1)
		switch (opt) {
		case 'l': landmarks = optarg; break;
		case 's': scale = 1; break;
		case NORMALS: o.normals = 1; break;
		case NO_NORMALS: o.normals = 0; break;
		case MAX_MU: o.mumax = opt_double(optarg, 0.01, 0.99, "max-mu"); break;
		case UV_A: uv[0] = optarg; break;
		case UV_B: uv[1] = optarg; break;
		case FORCE: o.force = 1; break;
		}
	if (!o.normals && !landmarks)
		misuse("--no-normals needs --landmarks");
	cmd_operands(argc, argv, 2, 2);
	cmd_binary_output();

	side_open(&a, argv[optind], uv[0]);
	side_open(&b, argv[optind+1], uv[1]);
	if (landmarks)
		marks_read(landmarks, &a, &b, &marks);
	side_match(&a, &b, scale);

	find_map(&a, &b, landmarks ? &marks : NULL, &o, &f);
	report(&f);
	sampled(&a, &b, &f, &out);
	cmd_write(&out);

	lhg_free(&out);
	if (landmarks)
		marks_free(&marks);
	side_free(&a);
	side_free(&b);
	return cmd_end();
}
