/* carry.h - numbers of a file to the vertices of a mesh, or of one that was made from it. */
#ifndef CMD_CARRY_H
#define CMD_CARRY_H

#include "../../lib/meshfile/fieldfile.h"

/* The numbers that the vertices of s have in the mesh of the file (MESH_SOURCE), or NULL if they are the same vertices.
 * Dies if the file has another number of them.  Prints a note where the file may be of either mesh. */
const double *carry_source(const char *path, const FieldFile *f, const Soup *s);

/* Sets to[s->nv] to the numbers `from` of the vertices with these numbers (NULL: of the same vertices).  A vertex that
 * has none, as mesh2disk made it, gets the mean of its neighbours'. */
void carry_numbers(const Soup *s, const double *source, const double *from, double *to);

#endif
