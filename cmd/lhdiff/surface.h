/* surface.h - surfaces from streams of grids or from a mesh file, whichever it is. */
#ifndef CMD_SURFACE_H
#define CMD_SURFACE_H

#include "../../lib/mesh/mesh.h"
#include "../shared/cmd.h"

/* The surfaces of one operand.  A mesh file has one, a stream as many as grids. */
typedef struct Surfaces {
	CmdInput in;            /* of grids */
	char    *bytes;         /* of a mesh file that has not been read yet, else NULL */
	size_t   n;
	int      grids;         /* it is a stream */
	long     count;         /* surfaces that came */
	char     place[300];    /* of the last, for messages: the name, and its number if there are
	                         * several */
} Surfaces;

/* path ("-": stdin) is taken for what its first bytes say. */
void surfaces_open(Surfaces *s, const char *path);

/* The next surface and 1, or 0 at the end; dies of a mesh that is no disk, and of grids
 * without channels x y z. */
int  surfaces_next(Surfaces *s, Mesh *m);

/* Whether another will come, after one came. */
int  surfaces_more(const Surfaces *s);

#endif
