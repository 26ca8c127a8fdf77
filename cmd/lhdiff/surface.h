/* surface.h - the surfaces of an operand: a stream of grids or a mesh file. */
#ifndef CMD_SURFACE_H
#define CMD_SURFACE_H

#include "../../lib/mesh/mesh.h"
#include "../shared/cmd.h"

/* The surfaces of one operand: one of a mesh file, or one for each grid of a stream. */
typedef struct Surfaces {
	CmdInput in;            /* of grids */
	char    *bytes;         /* of a mesh file that has not been read yet, else NULL */
	size_t   n;
	int      grids;         /* the operand is a stream of grids */
	long     count;         /* surfaces read so far */
	char     place[300];    /* name of the last in messages, with its number if there are
	                         * several */
} Surfaces;

/* Open path ("-": stdin); its first bytes decide whether it is a stream of grids. */
void surfaces_open(Surfaces *s, const char *path);

/* The next surface and 1, or 0 at the end; dies if a mesh has no face with area or a grid has no
 * channels x y z. */
int  surfaces_next(Surfaces *s, Mesh *m);

/* Whether another surface follows; to be called after the first. */
int  surfaces_more(const Surfaces *s);

#endif
