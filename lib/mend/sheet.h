/* sheet.h - triangles under repair.  Every side of a face has at most one twin; faces that share
 * vertices but no twins are not joined.  Private to lib/mend.
 *
 * Side 3f+k of face f goes from its corner k to corner k+1, as in mesh/topology.h.
 */
#ifndef SHEET_H
#define SHEET_H

#include "../mesh/mesh.h"

typedef struct Sheet {
	int     nv, nf;
	double *xyz;            /* [nv][3] */
	int    *source;         /* [nv] the vertex of the soup, -1 if it was made here */
	int    *tri;            /* [nf][3] */
	int    *twin;           /* [3*nf] the side of the neighbour, -1 on the boundary; NULL: not known */
	unsigned char *filled;  /* [nf] 1: the face fills a hole */
	char   *err;            /* MESH_ERRLEN */
} Sheet;

void sheet_free(Sheet *s);

/* Drops the faces f with keep[f] == 0.  Sides whose twin is dropped become boundary.
 * Returns 0 or MESH_ENOMEM. */
int sheet_keep(Sheet *s, const unsigned char *keep);

/* Drops the vertices that belong to no face.  Returns their number, or MESH_ENOMEM. */
int sheet_compact(Sheet *s);

/* Gives every fan of faces a vertex of its own: corners belong to one vertex if they can be reached
 * from one another across twins.  Vertices that no face has are dropped.
 *
 * was    in   [3*nf] the vertex that each corner had before vertices were welded, or NULL if none
 *             was.  A new vertex has the place in the order, the position and the source of the
 *             first of its old vertices that no vertex before it took; those left over follow at
 *             the end
 * merged out  how many old vertices became one with another
 * split  out  how many vertices were added
 *
 * Returns 0 or MESH_ENOMEM. */
int sheet_part(Sheet *s, const int *was, int *merged, int *split);

/* The corners at each vertex: those of v are corner[first[v]] .. corner[first[v+1]-1], ascending.
 * vertex is [n] with values below nv.  Both arrays are to be freed.  Returns 0 or MESH_ENOMEM. */
int sheet_corners(const int *vertex, int n, int nv, int **first, int **corner, char *err);

/* The representative of i in a union-find forest; paths are halved. */
static inline int
sheet_root(int *up, int i)
{
	while (up[i] != i)
		i = up[i] = up[up[i]];
	return i;
}

/* Joins the trees of a and b; the lower representative remains. */
static inline void
sheet_unite(int *up, int a, int b)
{
	a = sheet_root(up, a);
	b = sheet_root(up, b);
	if (a < b)
		up[b] = a;
	else
		up[a] = b;
}

static inline int
sheet_next(int side)
{
	return side % 3 == 2 ? side - 2 : side + 1;
}

static inline int
sheet_prev(int side)
{
	return side % 3 == 0 ? side + 2 : side - 1;
}

static inline int
sheet_to(const Sheet *s, int side)
{
	return s->tri[sheet_next(side)];
}

static inline const double *
sheet_at(const Sheet *s, int v)
{
	return s->xyz + 3*(size_t)v;
}

#endif
