/* uvopt.h - the option --uv of mesh2rect. */
#ifndef CMD_UVOPT_H
#define CMD_UVOPT_H

#include "../../lib/base/chart.h"
#include "../../lib/mesh/disk.h"

/* Exit 2 if the name FILE does not have the ending of a format with (u,v), or if FILE is also
 * the output or the operand mesh.  To be called after all options. */
void opt_uv(const char *file, const char *mesh);

/* The properties of the vertices of s, read with MESHFILE_FIELDS, which neither the map nor --with uses: moves all channels
 * but MESH_SOURCE to `own`. */
void uv_set_aside(Soup *s, Channels *own);

/* Write to FILE, or die: s, the vertices and polygons as the mesh file has them, with their (u,v) and
 * their offsets from the grid phi, and the channels `own`, which become part of s, but for those whose name s
 * has already.  d is the disk made from s; u and v are those of its vertices.  To be called before cmd_write, because
 * only one output can be open at a time, and a program that reads the grid from a pipe then finds FILE complete. */
void uv_write(const char *file, Soup *s, Channels *own, const Disk *d, const double *u, const double *v, Chart g,
	const double *const phi[3]);

#endif
