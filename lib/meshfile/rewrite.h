/* rewrite.h - an OBJ or PLY file with its vertices moved.
 *
 * All else stays, byte for byte: texture coordinates, materials, groups, colours, other properties, comments, the
 * order of everything, polygons.  Normals are computed again, from the faces by area: in OBJ each vn from the faces
 * whose corners use it, in PLY nx ny nz from the faces of the vertex.
 */
#ifndef REWRITE_H
#define REWRITE_H

#include <stddef.h>

#include "../mesh/mesh.h"

/* bytes, n  in   the file, not gzipped; an OBJ or PLY that meshfile_parse accepts
 * xyz       in   [nv][3] the new positions, in the order of the vertices of the file
 * out       out  malloc'd, of *outn bytes; its beginning, "ply" or not, tells which of both it is
 *
 * Returns 0; a code of meshfile_parse; or MESH_EFORMAT, with the reason in err: the file has another number of
 * vertices, is of another format, has its vertices in records of changing size or, in text, not each on a line of its
 * own, or a position is too large for it.  On failure there is nothing to free. */
int rewrite(const char *bytes, size_t n, int nv, const double *xyz, char **out, size_t *outn, char err[MESH_ERRLEN]);

#endif
