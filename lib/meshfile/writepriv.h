/* writepriv.h - what the mesh writers share.  Private to lib/. */
#ifndef WRITEPRIV_H
#define WRITEPRIV_H

#include <stddef.h>
#include <stdint.h>

#include "../mesh/mesh.h"

/* A file that grows in memory. */
typedef struct Text {
	char  *p;
	size_t n, cap;
} Text;

enum { TEXT_MAX = 400 };        /* more than any piece put at once */

/* Room for one more piece; 0 when there is no memory. */
int text_room(Text *t);

/* The n low bytes of w, least significant first. */
void text_bytes(Text *t, uint64_t w, int n);

/* All of a binary STL file.  Returns 0, MESH_ENOMEM or MESH_EVALUE. */
int text_stl(Text *t, const Mesh *m);

#endif
