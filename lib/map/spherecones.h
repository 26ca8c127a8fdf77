/* spherecones.h - the four cones of a pillow, chosen so that its cells are as equal on the surface as they can be.
 *
 * Given a conformal map of the surface onto the Riemann sphere (sphere.h), a Moebius map takes any three points to
 * any others, and the fourth cone is where the pillow of height T has it (pillowplane.h).  So there are seven numbers
 * to choose; those that minimise chi^2 (sphereparts.h) are looked for from several starts.  doc/mathematics.md 3.9.
 */
#ifndef SPHERECONES_H
#define SPHERECONES_H

#include "conemap.h"
#include "../mesh/mesh.h"

enum {
	SPHERECONES_ENOMEM = -1,
	SPHERECONES_EEQUAL = -2         /* two of the given cones, or the points of limbs, cannot be told apart */
};

typedef struct SphereCones {
	ConeMap map;
	double  chi2;
} SphereCones;

/* The cones of the mesh m, mapped by Z.  given: NULL, or three vertices, which become the cones (0,0), (1/2,0) and
 * (1/2,T); else T >= 1/2, as the pillow of height 1/(4T) is the same with u and v exchanged.
 * Returns 0, or one of the codes above. */
int spherecones(const Mesh *m, Spinor *Z, const int *given, SphereCones *c);

/* Sets c->chi2 to that of the cones of c->map.  Returns 0 or SPHERECONES_ENOMEM. */
int spherecones_chi2(const Mesh *m, Spinor *Z, SphereCones *c);

#endif
