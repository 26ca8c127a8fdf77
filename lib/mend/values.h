/* values.h - numbers at the vertices that mending made.  Private to lib/mend. */
#ifndef VALUES_H
#define VALUES_H

#include "../mesh/mesh.h"

/* Sets all channels of s, but MESH_SOURCE, at its vertices v with source[v] < 0, which fill holes: floating point numbers
 * and colours to the mean of their neighbours (spread.h), of whole numbers rounded; other whole numbers to those of the
 * nearest vertex that was there; normals nx ny nz to the mean direction, of length 1.  Returns 0 or MESH_ENOMEM. */
int values_made(Soup *s, const int *source);

#endif
