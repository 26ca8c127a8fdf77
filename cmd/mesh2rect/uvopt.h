/* uvopt.h - the option --uv of mesh2rect. */
#ifndef CMD_UVOPT_H
#define CMD_UVOPT_H

#include "../../lib/base/chart.h"
#include "../../lib/mesh/disk.h"

/* Exit 2 if the name FILE does not have the ending of a format with (u,v), or if FILE is also
 * the output or the operand mesh.  To be called after all options. */
void opt_uv(const char *file, const char *mesh);

/* Write s, the file's own vertices and polygons, with the (u,v) of the vertices of d, the
 * disk made from it, and their offsets from the grid phi, to FILE, or die.  Call it before
 * cmd_write: one output is open at a time,
 * and a program that reads the grid from a pipe finds FILE complete. */
void uv_write(const char *file, Soup *s, const Disk *d, const double *u, const double *v, Chart g,
	const double *const phi[3]);

#endif
