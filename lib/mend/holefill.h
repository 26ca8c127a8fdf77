/* holefill.h - triangles across holes, by CGAL. */
#ifndef HOLEFILL_H
#define HOLEFILL_H

#include "../mesh/mesh.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { HOLEFILL_ENOMEM = -1, HOLEFILL_ECGAL = -2 };

/* A hole that has no triangulation among the Delaunay tetrahedra of its vertices is filled by a search
 * over all triangulations if it has at most this many vertices: the time of the search grows as the cube
 * of their number. */
enum { HOLEFILL_CUBIC = 500 };

/* The patches that fill holes: vertices with numbers from the nv of the mesh on, and faces. */
typedef struct HolePatch {
	Mesh m;                 /* m.xyz the new vertices, m.tri the new faces */
	unsigned char *done;    /* [n] 0: no triangulation was found for that hole */
} HolePatch;

/* Fills n holes of a mesh.  Each is triangulated with the least area and bend, and the triangles are
 * refined until they are as dense as those round the hole.
 *
 * m   in  oriented, with one fan of faces at each vertex
 * at  in  [n][2] the ends of a boundary side of each hole, in the direction of its face
 *
 * Returns 0, HOLEFILL_ENOMEM, or HOLEFILL_ECGAL if CGAL fails or the mesh is not as said. */
int holefill(const Mesh *m, int n, const int (*at)[2], HolePatch *p);

void holefill_free(HolePatch *p);

#ifdef __cplusplus
}
#endif

#endif
