/* pointface.h - faces on points that have none, by CGAL's advancing front. */
#ifndef POINTFACE_H
#define POINTFACE_H

#ifdef __cplusplus
extern "C" {
#endif

enum { POINTFACE_ENOMEM = -1, POINTFACE_ECGAL = -2 };

/* Triangles of the Delaunay triangulation of the points, put together from the most plausible on, so
 * that they form an oriented surface [D. Cohen-Steiner, F. Da, A greedy Delaunay-based surface
 * reconstruction algorithm, The Visual Computer 20 (2004) 4-16].  Points that are not finite are left
 * out.
 *
 * xyz   in   [n][3]
 * tri   out  [*nf][3], to be freed
 *
 * Returns 0, POINTFACE_ENOMEM or POINTFACE_ECGAL. */
int pointface(int n, const double *xyz, int **tri, int *nf);

#ifdef __cplusplus
}
#endif

#endif
