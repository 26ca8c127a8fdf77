/* mkmesh - triangle meshes of surfaces given by a formula */
#include <stdlib.h>

#include "../lib/meshfile/meshfile.h"
#include "shared/cmd.h"
#include "shared/formats.h"
#include "mkmesh/kinds.h"

static const char head[] =
"usage: mkmesh [-n VERTICES] [--seed=S] [-o FILE] KIND [NAME=VALUE ...] >mesh.off\n"
"Writes an unstructured triangle mesh of a surface phi(x,y) over a plane domain, a disk, or of a\n"
"closed surface over the unit sphere, as\n"
"{stdout} to stdout, or to FILE in the format that its name ends in, {ends}.\n"
"Faces are counterclockwise seen from the side to which the normal phi_x cross phi_y points;\n"
"that is the outside of closed surfaces.  Vertices 0 1 2 3 are the corners of the domain,\n"
"counterclockwise: of a rectangle from the lower left one, of a disk or oval the points at\n"
"-135, -45, 45 and 135 degrees.\n"
"  -n, --vertices=N   about N vertices, 8..10000000 [5000]\n"
"      --seed=S       random seed of the inner vertices, 0..2147483647 [1]\n"
"      --list         print the names of the kinds\n"
CMD_USAGE
"Example: mkmesh -n 20000 --seed=2 cap -o cap.ply\n"
"Below, T is the modulus of the domain with its four corners: the height of the rectangle of\n"
"width 1 that it maps to conformally.  lambda = |phi_x| = |phi_y| where phi is conformal; H is\n"
"the mean curvature, -1 on the unit sphere.  Angles are in degrees.  Each kind is followed by\n"
"its parameters, as NAME=default, range, and by its formula:\n";

static const struct option longopt[] = {
	{ "vertices", required_argument, NULL, 'n' },
	{ "seed",     required_argument, NULL, 's' },
	{ "list",     no_argument,       NULL, 'l' },
	CMD_LONGOPT
};

int
main(int argc, char *argv[])
{
	static char headed[FORMATS_USAGE];
	const char *out;
	const MeshFormat *format;
	char *bytes, *usage, list[MESHFORMAT_LIST];
	int opt, err, n = 5000, listed = 0;
	uint64_t seed = 1;
	size_t size;
	Synth s;
	Mesh m;

	cmd_begin("mkmesh", head);              /* kinds_manual may die, with this name in the message */
	cmd_begin("mkmesh", usage = kinds_manual(formats_usage(head, headed, sizeof headed)));
	while ((opt = cmd_getopt(argc, argv, "n:", longopt)) != -1)
		switch (opt) {
		case 'n': n = (int)opt_long(optarg, 8, 10000000, "vertices"); break;
		case 's': seed = (uint64_t)opt_long(optarg, 0, 2147483647, "seed"); break;
		case 'l': listed = 1; break;
		}
	cmd_operands(argc, argv, listed ? 0 : 1, listed ? 0 : 1 + SYNTH_MAXPAR);
	if (listed) {
		kinds_list();
		return cmd_end();
	}
	if (synth_init(&s, argv[optind]))
		misuse("%s: no such kind of surface (mkmesh --list prints them)", argv[optind]);
	while (++optind < argc)
		kinds_set(&s, argv[optind]);
	out = cmd_output();
	if (!(format = out ? meshformat_of(out) : meshformat(0)))
		misuse("--output=%s: need a name that ends in %s", out, meshformat_ends(MESHFORMAT_WRITE, list));

	switch (err = synth_mesh(&s, n, seed, &m, NULL)) {
	case 0: break;
	case SYNTH_ENOMEM: die("no memory for %d vertices", n);
	case SYNTH_EDOMAIN: misuse("the %s is empty with these parameters", s.kind->name);
	default: die("%d vertices are too few for this %s", n, s.kind->name);
	}
	if (meshfile_write_mesh(&m, format, &bytes, &size))
		die("no memory for the file of %d vertices", m.nv);
	cmd_write_bytes(NULL, bytes, size);

	mesh_free(&m);
	free(bytes);
	err = cmd_end();
	free(usage);
	return err;
}
