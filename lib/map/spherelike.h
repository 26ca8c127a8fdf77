/* spherelike.h - the cones of one closed surface where they are on another.
 *
 * Two closed surfaces A and B are mapped conformally to the sphere, A as a pillow of height T.  Any Moebius map from the sphere
 * of B to that of A makes B a pillow of the same height, so that six numbers are free.  Taken is the map w that minimises
 *
 *   mean over the area of B of |R x + t - phi_A(w(Z))|^2,
 *
 * x a point of B and Z its place on the sphere, over w and the rigid motions R, t; both surfaces are first moved to mean 0 and
 * scaled to the same root mean square distance from it.  doc/mathematics.md 8.3.
 */
#ifndef SPHERELIKE_H
#define SPHERELIKE_H

#include "conemap.h"
#include "likegrid.h"

enum {
	SPHERELIKE_ENOMEM = -1,
	SPHERELIKE_EEQUAL = -2          /* the surfaces, or given cones, cannot be brought onto each other */
};

typedef struct SphereLike {
	ConeMap map;
	double  rms;            /* root mean square distance of equal places, over that from the mean */
	double  next;           /* that of the best fit with B turned otherwise, by 30 degrees or more; infinite: there is none */
} SphereLike;

/* Fits the mesh m, mapped by Z, to phi on the pillow g, nu, nv >= 6.  given: NULL, or three vertices of m that become the cones
 * (0,0), (1/2,0) and (1/2,T); then nothing is free, and next is infinite.  Returns 0 or one of the codes above. */
int spherelike(const Mesh *m, Spinor *Z, const int *given, Chart g, const double *const phi[3], SphereLike *l);

#endif
