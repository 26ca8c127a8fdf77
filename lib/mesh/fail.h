/* fail.h - messages and memory of the functions that read, check and repair meshes. */
#ifndef FAIL_H
#define FAIL_H

#include <stddef.h>

#include "mesh.h"

/* Put the message into err and give code back. */
int mesh_fail(char err[MESH_ERRLEN], int code, const char *fmt, ...);

/* n things of size bytes, or NULL with err saying how much was wanted.  n may be 0. */
void *mesh_alloc(char err[MESH_ERRLEN], size_t n, size_t size);

#endif
