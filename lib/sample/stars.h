/* stars.h - the triangles at each vertex of a mesh with a chart. */
#ifndef STARS_H
#define STARS_H

#include "../mesh/mesh.h"

enum {
	STARS_ENOMEM = -1,
	STARS_FEW    = 16       /* a vertex of more triangles counts as a hub */
};

/* The star of each vertex, that is, the triangles at it.  Those of vertex i are side[first[i]] ..
 * side[first[i+1]-1], each as 3*t + k, where i is corner k of triangle t.
 *
 * If i is a hub, some of its neighbours are enough to fit a surface: near[k] for k =
 * STARS_FEW*hub[i] .. STARS_FEW*hub[i] + STARS_FEW-1, those in STARS_FEW directions from i, then -1
 * for each direction without a triangle.  (A vertex of a million triangles would otherwise cost each
 * neighbour a million visits.)
 *
 * Order and choice depend on (u,v), not on how vertices and triangles are numbered.  They stay the
 * same when the rectangle is reflected or turned. */
typedef struct Stars {
	int *first, *side;
	int *hub;       /* [nv] the number of a hub, -1 for other vertices */
	int *near;      /* [STARS_FEW for each hub] */
} Stars;

/* u, v: [m->nv].  Returns 0, or STARS_ENOMEM with nothing to free. */
int  stars_init(Stars *s, const Mesh *m, const double *u, const double *v);
void stars_free(Stars *s);

#endif
