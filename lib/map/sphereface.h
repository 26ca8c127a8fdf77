/* sphereface.h - how conformal the faces of a mesh are on the sphere. */
#ifndef SPHEREFACE_H
#define SPHEREFACE_H

#include "../base/moebius.h"
#include "../mesh/mesh.h"

/* Twice the area of face t on the surface. */
double sphereface_area2(const Mesh *m, int t);

/* The energy of face t less the area of its image, on the unit sphere.  It is >= 0, and 0 only if the face is mapped
 * conformally. */
double sphereface_term(const Mesh *m, Spinor *Z, int t);

/* The mean of |mu| over the surface, mu the Beltrami coefficient of the faces, at most 1; and the number of faces
 * that are turned over or flat on the sphere. */
void sphereface_beltrami(const Mesh *m, Spinor *Z, double *mu, int *turned);

#endif
