/* topology.h - how triangles hang together.  Private to lib/.
 *
 * Side 3f+k of face f goes from its corner k to corner k+1.  All in time linear in the
 * mesh, but for sorting the sides around one vertex.
 */
#ifndef TOPOLOGY_H
#define TOPOLOGY_H

#include "mesh.h"

typedef struct Topology {
	int        nv, nf;
	const int *tri;
	int       *twin;        /* [3*nf] the side of the neighbour, -1 on the boundary */
	int        nedge;
	int        odd;         /* some twins go the same way: their faces disagree */
	const int *file;        /* [nv] numbers to name vertices by, or NULL: as they are */
	char      *err;         /* MESH_ERRLEN */
} Topology;

/* Fill twin, nedge and odd from tri; free(t->twin).  Returns 0, MESH_ENOMEM, or
 * MESH_EMANIFOLD: an edge of more than two faces. */
int topology_twins(Topology *t);

/* Find the faces to turn so that neighbours agree: in each component those that do not
 * stand as its first face does.  turn is [nf], 1 to turn, 0 not.  0, MESH_ENOMEM, or
 * MESH_EORIENT: no way. */
int topology_orient(const Topology *t, signed char *turn);

/* One component?  Vertices belong together when a face has both.  Every vertex must be
 * of a face.  0, MESH_ENOMEM or MESH_EDISK. */
int topology_connected(const Topology *t);

/* One fan of faces at every vertex?  Needs !odd.  0, MESH_ENOMEM or MESH_EMANIFOLD. */
int topology_fans(const Topology *t);

/* The one boundary loop, as in Disk; needs all of the above.  0, MESH_ENOMEM, or
 * MESH_EDISK: no loop, several, or handles. */
int topology_loop(const Topology *t, int **loop, int *nb);

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
