/* beside.h - files beside a mesh file that hold a part of it.  Private to lib/. */
#ifndef BESIDE_H
#define BESIDE_H

#include "meshpriv.h"

/* Reads bytes from .. from + n-1 of the file `name` beside the mesh file.  *bytes is malloc'd.  Names are refused that
 * leave the folder of the mesh file: those with a / at their start, or with .. for one of their folders.  `what` names
 * what the file holds in messages, as in "buffer 0".  Returns 0, or MESH_ENOMEM or MESH_EFORMAT with the reason in
 * r->s->err and *bytes as it was. */
int beside_read(Reader *r, const char *what, Token name, long long from, size_t n, char **bytes);

#endif
