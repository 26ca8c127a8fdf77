/* gridfile.h - a grid as the bytes of a mesh file, for grid2mesh. */
#ifndef CMD_GRIDFILE_H
#define CMD_GRIDFILE_H

#include "../../lib/meshfile/meshformat.h"
#include "../shared/cmd.h"

/* The mesh of --on with its (u,v), or die; how many vertices have none is noted. */
void gridfile_on(const char *path, Soup *s);

/* The bytes of a mesh file of that format, or die: the grid's own nodes and triangles, or,
 * on not NULL, the vertices of on moved to their (u,v) and its faces. */
void gridfile_format(const CmdInput *in, const Lhg *g, const Soup *on, const char *onname, const MeshFormat *format,
	char **bytes, size_t *n);

#endif
