/* pair.h - the two surfaces of lhwarp. */
#ifndef CMD_PAIR_H
#define CMD_PAIR_H

#include "../../lib/base/chart.h"
#include "../../lib/mesh/mesh.h"
#include "../../lib/meshfile/meshfile.h"
#include "../shared/cmd.h"

/* One surface: a grid, and the mesh it was sampled from if the user gives it. */
typedef struct Side {
	CmdInput in;
	Lhg      g;
	Chart    chart;
	double  *phi[3];
	double   area;
	const char *mesh;       /* name of the mesh file, or NULL: neither s nor d is set */
	Soup     s;             /* with the channel MESH_UV */
	Disk     d;
} Side;

/* Reads one grid x y z on the rectangle from `path`, and the mesh with (u,v) from `mesh` unless that is NULL;
 * or dies. */
void side_open(Side *s, const char *path, const char *mesh);
void side_free(Side *s);

/* Scales b about the origin to the area of a: positions, channels in length and in 1/length.  Or, if it is not to
 * be scaled, says so where the sizes differ much. */
void side_match(const Side *a, Side *b, int scaled);

#endif
