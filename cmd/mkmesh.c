/* mkmesh - triangle meshes of surfaces given by a formula */
#include <stdlib.h>

#include "../lib/meshfile/meshfile.h"
#include "shared/cmd.h"
#include "shared/formats.h"
#include "mkmesh/kinds.h"

static const char head[] =
"usage: mkmesh [-n VERTICES] [--seed=S] [-o FILE] KIND [NAME=VALUE ...] >mesh.off\n"
"Writes an unstructured triangulation of a surface (x,y) -> phi(x,y), a disk, as {stdout}, or\n"
"as {formats} by the end of FILE.  Faces are counterclockwise seen against\n"
"phi_x x phi_y, which points out of closed surfaces.  Vertices 0 1 2 3 are the corners\n"
"of the domain, counterclockwise: of a rectangle from its lower left one, of a disk or\n"
"oval the points at -135, -45, 45 and 135 degrees.\n"
"  -n, --vertices=N   about N vertices, 8..10000000 [5000]\n"
"      --seed=S       random seed of the vertices inside, 0..2147483647 [1]\n"
"      --list         print the names of the kinds\n"
CMD_USAGE
"T is the modulus of a domain with its corners, lambda = |phi_x| = |phi_y|, H the mean\n"
"curvature (-1 on the unit sphere).  Angles are in degrees.  Kinds, NAME=default, range:\n";

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
		misuse("%s: no such kind, see --list", argv[optind]);
	while (++optind < argc)
		kinds_set(&s, argv[optind]);
	out = cmd_output();
	if (!(format = out ? meshformat_of(out) : meshformat(0)))
		misuse("--output=%s: need an end of %s", out, meshformat_ends(MESHFORMAT_WRITE, list));

	switch (err = synth_mesh(&s, n, seed, &m, NULL)) {
	case 0: break;
	case SYNTH_ENOMEM: die("no memory for %d vertices", n);
	case SYNTH_EDOMAIN: misuse("the parameters leave nothing of the %s", s.kind->name);
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
