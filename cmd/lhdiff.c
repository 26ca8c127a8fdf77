/* lhdiff - how far two surfaces are apart */
#include "cmd.h"
#include "compare.h"
#include "surface.h"

static const char text[] =
"usage: lhdiff [--json] [--hausdorff-error=E] [--no-hausdorff]\n"
"              [--no-self-intersections] A B\n"
"Compares surface B with A, the reference.  Each is a stream of one grid with channels\n"
"x y z, or a mesh file (OFF, OBJ, PLY, STL); - is stdin.  Prints lines \"name value\":\n"
"  area_a area_b      areas\n"
"  max mean           distance between vertices of equal number, left out where the\n"
"                     numbers of vertices differ\n"
"  hausdorff          symmetric Hausdorff distance of the surfaces, faces and all, to\n"
"  hausdorff_error    plus or minus this; not more than this, where the two are equal\n"
"  max_rel mean_rel hausdorff_rel   the same over the square root of the area of A\n"
"  self_intersections_a, _b   pairs of faces that meet where they are not joined\n"
"Options:\n"
"      --json         one JSON object instead\n"
"      --hausdorff-error=E  hausdorff_error over the square root of the area of A,\n"
"                     1e-7..1 [1e-3]; the time grows as 1/E where the surfaces are\n"
"                     nearer to each other than that\n"
"      --no-hausdorff, --no-self-intersections   leave these out\n"
CMD_USAGE
"Exit 0 whatever the distance, 1 when a surface cannot be read or has no area.\n";

static const struct option longopt[] = {
	{ "json",                  no_argument,       NULL, 'j' },
	{ "hausdorff-error",       required_argument, NULL, 'e' },
	{ "no-hausdorff",          no_argument,       NULL, 'H' },
	{ "no-self-intersections", no_argument,       NULL, 'S' },
	CMD_LONGOPT
};

int
main(int argc, char *argv[])
{
	double value[COMPARE_N], error = 1e-3;
	int opt, json = 0, far = 1, cross = 1;
	Mesh a, b;

	cmd_begin("lhdiff", text);
	while ((opt = cmd_getopt(argc, argv, "", longopt)) != -1)
		switch (opt) {
		case 'j': json = 1; break;
		case 'e': error = opt_double(optarg, 1e-7, 1, "hausdorff-error"); break;
		case 'H': far = 0; break;
		case 'S': cross = 0; break;
		}
	cmd_operands(argc, argv, 2, 2);
	surface_load(argv[optind], &a);
	surface_load(argv[optind+1], &b);

	compare((const char *const *)argv + optind, &a, &b, error, far, cross, value);
	compare_print(value, json);

	mesh_free(&a);
	mesh_free(&b);
	return cmd_end();
}
