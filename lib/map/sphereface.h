/* sphereface.h - how conformal the faces of a mesh are on the sphere. */
#ifndef SPHEREFACE_H
#define SPHEREFACE_H

#include "../base/moebius.h"
#include "../mesh/mesh.h"

/* Twice the area of face t on the surface. */
double sphereface_area2(const Mesh *m, int t);

/* 2 |mu|^2 times the area of face t, mu its Beltrami coefficient, |mu| at most 1.  For small mu, 2 |mu|^2 is the Dirichlet
 * energy over the area of the image, minus 1. */
double sphereface_term(const Mesh *m, Spinor *Z, int t);

/* The mean of |mu| over the surface, mu the Beltrami coefficient of the faces, at most 1; and the number of faces
 * that are turned over or flat on the sphere. */
void sphereface_beltrami(const Mesh *m, Spinor *Z, double *mu, int *turned);

#endif
