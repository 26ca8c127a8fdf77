/* filled.h - the faces of a soup that fill holes. */
#ifndef FILLED_H
#define FILLED_H

#include "mesh.h"

/* Drops the faces that fill holes, and the vertices that only they have; the other vertices keep their
 * order.  s->filled is then NULL.  Returns the number of faces dropped, or MESH_ENOMEM with the reason
 * in s->err and the soup unchanged. */
int filled_drop(Soup *s);

#endif
