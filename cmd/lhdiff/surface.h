/* surface.h - the surfaces of an operand: a stream of grids or a mesh file. */
#ifndef CMD_SURFACE_H
#define CMD_SURFACE_H

#include "../../lib/mesh/mesh.h"
#include "../shared/cmd.h"

/* The surfaces of one operand: the one of a mesh file, or one for each grid of a stream. */
typedef struct Surfaces {
	CmdInput in;            /* the stream of grids; of a mesh file only the name */
	const char *path;
	char    *bytes;         /* [n] of a mesh file that has not been parsed yet, else NULL */
	size_t   n;
	int      grids;         /* the operand is a stream of grids */
	long     count;         /* surfaces read so far */
	char     place[300];    /* the last surface in messages: the name of the operand, with the
	                         * number of the surface if there are several */
} Surfaces;

/* Open path ("-": stdin); its first bytes decide whether it is a stream of grids. */
void surfaces_open(Surfaces *s, const char *path);

/* Sets m to the next surface and returns 1, or returns 0 at the end.  Dies if a mesh has no face with
 * area or a grid has no channels x y z. */
int  surfaces_next(Surfaces *s, Mesh *m);

/* Whether another surface follows; to be called after the first. */
int  surfaces_more(const Surfaces *s);

#endif
