/* join.h - which faces are neighbours: the twins of a sheet.  Private to lib/mend. */
#ifndef JOIN_H
#define JOIN_H

#include "sheet.h"

/* Sets s->twin.  Two faces at an edge become neighbours.  Of three or more faces at an edge, those of
 * the largest parts of the surface become neighbours, in pairs; a part consists of faces connected
 * across edges of two faces.  Within a part, neighbours agree in orientation if they can, and continue
 * each other with the least bend.
 *
 * many  out  the number of edges of three or more faces
 * at    out  the two ends of the first of them
 * flap  out  [nf] 1 for the faces at these edges that are not in the first pair, else 0; may be NULL
 *
 * Returns 0 or MESH_ENOMEM. */
int sheet_join(Sheet *s, int *many, int at[2], unsigned char *flap);

#endif
