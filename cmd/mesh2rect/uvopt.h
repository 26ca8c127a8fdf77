/* uvopt.h - the option --uv of mesh2rect. */
#ifndef CMD_UVOPT_H
#define CMD_UVOPT_H

#include "../../lib/base/chart.h"
#include "../../lib/mesh/disk.h"

/* Exit 2 if the name FILE does not have the ending of a format with (u,v), or if FILE is also
 * the output or the operand mesh.  To be called after all options. */
void opt_uv(const char *file, const char *mesh);

/* Write to FILE, or die: s, the vertices and polygons as the mesh file has them, with their (u,v) and
 * their offsets from the grid phi.  d is the disk made from s; u and v are those of its vertices.  To
 * be called before cmd_write, because only one output can be open at a time, and a program that reads
 * the grid from a pipe then finds FILE complete. */
void uv_write(const char *file, Soup *s, const Disk *d, const double *u, const double *v, Chart g,
	const double *const phi[3]);

#endif
