/* spherecones.h - the four cones of a pillow, chosen so that its cells are as equal on the surface as they can be.
 *
 * Given a conformal map of the surface onto the Riemann sphere (sphere.h), the cells of the pillow have the areas
 *
 *   a ~ S/(|p_0 x Z| |p_1 x Z| |p_2 x Z| |p_3 x Z|),   p x Z = p[0] Z[1] - p[1] Z[0],
 *
 * for a part of area S on the sphere and cones at p_k.  A Moebius map takes any three points to any others, and the
 * fourth cone is where the pillow of height T has it (pillowplane.h).  So there are seven numbers to choose; those
 * that minimise chi^2 (parts.h) are looked for from several starts.  doc/mathematics.md 3.9.
 */
#ifndef SPHERECONES_H
#define SPHERECONES_H

#include "../mesh/mesh.h"
#include "sphere.h"

enum { SPHERECONES_ENOMEM = -1, SPHERECONES_EEQUAL = -2 /* two of the given cones are equal */ };

/* The Moebius map to the sphere of the pillow of height T. */
typedef struct SphereCones {
	double complex M[2][2]; /* of determinant 1 */
	double T, chi2;
} SphereCones;

/* The cones of the mesh m, mapped by Z.  given: NULL, or three vertices, which become the cones (0,0), (1/2,0) and
 * (1/2,T). */
int spherecones(const Mesh *m, Spinor *Z, const int *given, SphereCones *c);

/* The point of the sphere of the pillow at Z, of norm 1; and Z at that point. */
void spherecones_move(const SphereCones *c, const Spinor Z, Spinor w);
void spherecones_back(const SphereCones *c, const Spinor w, Spinor Z);

#endif
