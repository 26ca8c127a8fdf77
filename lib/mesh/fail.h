/* fail.h - error messages and memory for reading, checking and repairing meshes. */
#ifndef FAIL_H
#define FAIL_H

#include <stddef.h>

#include "mesh.h"

/* Put the message into err; returns code. */
int mesh_fail(char err[MESH_ERRLEN], int code, const char *fmt, ...);

/* n items of size bytes, or NULL with the size in err.  n may be 0. */
void *mesh_alloc(char err[MESH_ERRLEN], size_t n, size_t size);

#endif
