/* rectmap.h - conformal map of a disk onto a rectangle, by two cotangent systems.
 *
 * Four corners make the disk a quadrilateral.  u is harmonic, 0 on its left side, 1 on its
 * right side, and free on the others.  v1 is harmonic, 0 on the bottom, 1 on the top.  The
 * Dirichlet energies, of the metric (3) of the mesh, bound the conformal modulus T* of the
 * quadrilateral, E(u) >= T* >= 1/E(v1), so
 *
 *   map          p -> (u,v),   v = T v1                                      (4)
 *   conformal    T = sqrt(E(u)/E(v1))                                        (6)
 *   certificate  sqrt(E(u) E(v1)) - 1 >= 0,
 *
 * where the certificate is 0 only for an exactly conformal map (doc/mathematics.md 3.1, 3.2).
 */
#ifndef RECTMAP_H
#define RECTMAP_H

#include "cotangent.h"
#include "../mesh/mesh.h"
#include "../sparse/spd.h"

/* d          the disk
 * coarse     NULL, or the disk that d was before all its triangles were split into four
 *            (refine_split with NULL): then the elements are the quadratic ones of coarse.
 *            The error of (u,v) is O(h^3) instead of O(h^2) where the mesh is irregular, and
 *            the certificate is that of these elements
 * corner     indices into the boundary loop (corners.h)
 * u, v       out  [nv] the map: 0 <= u <= 1 and 0 <= v <= T, except where cotangents are negative
 * report     out  bytes: size of the factor, 0 if not known; column: on SPD_EINDEFINITE, the vertex
 *
 * The result has the same bits for any number of threads.
 *
 * Returns 0, or one of SPD_ENOMEM, SPD_EINDEFINITE, SPD_ELARGE. */
int rectmap(const Disk *d, const Disk *coarse, const int corner[4], double *u, double *v, double *T,
	double *certificate, SpdReport *report);

/* The number of triangles that the map turns over ((u,v) area < 0); and of those it makes flat
 * (area 0). */
int rectmap_flipped(const Mesh *m, const double *u, const double *v);
int rectmap_flat(const Mesh *m, const double *u, const double *v);

#endif
