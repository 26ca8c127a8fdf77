/* fail.h - error messages and memory for reading, checking and repairing meshes. */
#ifndef FAIL_H
#define FAIL_H

#include <stddef.h>

#include "mesh.h"

/* Writes the message to err.  Returns code. */
int mesh_fail(char err[MESH_ERRLEN], int code, const char *fmt, ...);

/* Allocates n items of size bytes.  Returns NULL, with a message in err, if memory runs out.  n may
 * be 0. */
void *mesh_alloc(char err[MESH_ERRLEN], size_t n, size_t size);

#endif
