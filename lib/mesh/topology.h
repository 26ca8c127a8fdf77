/* topology.h - connectivity of a triangle mesh: twins, orientation, fans, the boundary loop.
 * Private to lib/.
 *
 * Side 3f+k of face f goes from its corner k to corner k+1.  Time is linear in the mesh,
 * except for sorting the sides at each vertex.
 */
#ifndef TOPOLOGY_H
#define TOPOLOGY_H

#include "mesh.h"

typedef struct Topology {
	int        nv, nf;
	const int *tri;
	int       *twin;        /* [3*nf] the side of the neighbour, -1 on the boundary */
	int        nedge;
	int        odd;         /* 1: some twins run in the same direction: faces disagree */
	const int *file;        /* [nv] vertex numbers for messages, or NULL: their own */
	char      *err;         /* MESH_ERRLEN */
} Topology;

/* Fill twin, nedge and odd from tri; the caller frees twin.  Returns 0, MESH_ENOMEM, or
 * MESH_EMANIFOLD: an edge of more than two faces. */
int topology_twins(Topology *t);

/* Find the faces to turn so that neighbours agree: in each component those that disagree with
 * its first face.  turn is [nf], 1 to turn, 0 not.  Returns 0, MESH_ENOMEM, or MESH_EORIENT if
 * neighbours cannot be made to agree. */
int topology_orient(const Topology *t, signed char *turn);

/* Check that the mesh has one component.  Faces that share a vertex belong to the same component.
 * Every vertex must belong to a face.  Returns 0, MESH_ENOMEM or MESH_EDISK. */
int topology_connected(const Topology *t);

/* Check that every vertex has one fan of faces.  Needs odd == 0.  Returns 0, MESH_ENOMEM or
 * MESH_EMANIFOLD. */
int topology_fans(const Topology *t);

/* The one boundary loop, as in Disk; the caller frees it.  Needs all checks above.  Returns 0,
 * MESH_ENOMEM, or MESH_EDISK: no loop, several, or handles. */
int topology_loop(const Topology *t, int **loop, int *nb);

/* Whether no edge is on a boundary; and the genus of a closed mesh that passed the checks above. */
int topology_is_closed(const Topology *t);
int topology_genus(const Topology *t);

static inline int
topology_next(int side)
{
	return side % 3 == 2 ? side - 2 : side + 1;
}

static inline int
topology_from(const Topology *t, int side)
{
	return t->tri[side];
}

static inline int
topology_to(const Topology *t, int side)
{
	return t->tri[topology_next(side)];
}

static inline int
topology_name(const Topology *t, int v)
{
	return t->file ? t->file[v] : v;
}

#endif
