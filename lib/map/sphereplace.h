/* sphereplace.h - places of the vertices of a closed mesh, in the plane of z and on the sphere. */
#ifndef SPHEREPLACE_H
#define SPHEREPLACE_H

#include "../base/moebius.h"
#include "../mesh/subdivision.h"

enum { SPHEREPLACE_ENOMEM = -1 };
#define SPHEREPLACE_FAR 1e100   /* stands for z = infinity */

/* Moves and scales z, [nv], so that the mean of the area on the sphere is 0.  Returns 0 or SPHEREPLACE_ENOMEM. */
int  sphereplace_centre(const Mesh *m, double complex *z);

/* Mirrors z if most faces are turned over. */
void sphereplace_orient(const Mesh *m, double complex *z);

/* Z = z, and z = Z. */
void sphereplace_put(int n, const double complex *z, Spinor *Z);
void sphereplace_get(int n, Spinor *Z, double complex *z);

/* The places of the vertices of s from number `from` on: the means of those of their faces. */
void sphereplace_extend(const Subdivision *s, int from, Spinor *Z);

#endif
