/* keep.h - the option --keep of grid2mesh: the user's own file with its vertices moved. */
#ifndef CMD_KEEP_H
#define CMD_KEEP_H

#include "gridfile.h"

/* Makes the bytes of the file `keep`, an OBJ or PLY, with its vertices moved as those of the mesh of --on.  That mesh has its
 * vertices, or was made from it by mesh2disk and says so by the channel MESH_SOURCE: then a vertex with several copies
 * moves to their mean, one that was welded to another moves as the other, and those of parts left out stay, which is
 * noted.  Dies if it is no such file, or of another format than the output. */
void keep_bytes(const CmdInput *in, const Lhg *g, const OnMesh *on, const char *keep, const MeshFormat *format,
	char **bytes, size_t *n);

/* Makes the bytes of a file of the fields alone, at the vertices of the mesh file `keep`, in the same way: the mean of the
 * copies of a vertex, NaN at those of parts left out. */
void keep_field_bytes(const CmdInput *in, const Lhg *g, const OnMesh *on, const char *keep, const Fields *fields,
	const FieldFormat *format, char **bytes, size_t *n);

#endif
