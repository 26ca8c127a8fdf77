/* gridfile.h - a grid as the bytes of a mesh file, for grid2mesh. */
#ifndef CMD_GRIDFILE_H
#define CMD_GRIDFILE_H

#include "../../lib/meshfile/meshformat.h"
#include "../shared/cmd.h"

/* Reads the mesh of --on with its (u,v), or dies; notes the number of vertices without (u,v). */
void gridfile_read_mesh(const char *path, Soup *s);

/* The bytes of a mesh file of that format, or die: the nodes of the grid and two triangles for each
 * cell; or, if on is not NULL, the faces of on with its vertices moved to their (u,v) on the grid. */
void gridfile_bytes(const CmdInput *in, const Lhg *g, const Soup *on, const char *onname,
	const MeshFormat *format, char **bytes, size_t *n);

#endif
