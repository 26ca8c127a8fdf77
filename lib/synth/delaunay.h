/* delaunay.h - Delaunay triangulation of points in the plane (CGAL). */
#ifndef DELAUNAY_H
#define DELAUNAY_H

#ifdef __cplusplus
extern "C" {
#endif

enum {
	DELAUNAY_ENOMEM = -1,
	DELAUNAY_EPOINT = -2,   /* two points are equal, or all lie on one line */
	DELAUNAY_ECGAL  = -3    /* CGAL failed */
};

/* The Delaunay triangles of n >= 3 finite points, counterclockwise, none of zero area:
 * predicates are exact.  The same points in the same order give the same triangles in
 * the same order.
 *
 * xy   in   [n][2]
 * tri  out  [2*n][3], the first *nf are set
 *
 * Returns 0 or one of the codes above. */
int delaunay(int n, const double *xy, int *tri, int *nf);

#ifdef __cplusplus
}
#endif

#endif
