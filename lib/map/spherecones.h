/* spherecones.h - the four cones of a pillow, chosen so that its cells are as equal on the surface as they can be.
 *
 * Given a conformal map of the surface onto the Riemann sphere (sphere.h), a Moebius map takes any three points to
 * any others, and the fourth cone is where the pillow of height T has it (pillowplane.h).  So there are seven numbers
 * to choose; those that minimise chi^2 (sphereparts.h) are looked for from several starts.  doc/mathematics.md 3.9.
 */
#ifndef SPHERECONES_H
#define SPHERECONES_H

#include "../base/moebius.h"
#include "../mesh/mesh.h"

enum { SPHERECONES_ENOMEM = -1, SPHERECONES_EEQUAL = -2 /* two cones cannot be told apart */ };

/* The Moebius map to the sphere of the pillow of height T. */
typedef struct SphereCones {
	Moebius M;              /* of determinant 1 */
	double  T, chi2;
} SphereCones;

/* The cones of the mesh m, mapped by Z.  given: NULL, or three vertices, which become the cones (0,0), (1/2,0) and
 * (1/2,T); else T >= 1/2, as the pillow of height 1/(4T) is the same with u and v exchanged.
 * Returns 0, or one of the codes above. */
int spherecones(const Mesh *m, Spinor *Z, const int *given, SphereCones *c);

/* The point of the sphere of the pillow at Z, of norm 1; and Z at that point. */
void spherecones_move(const SphereCones *c, const Spinor Z, Spinor w);
void spherecones_back(const SphereCones *c, const Spinor w, Spinor Z);

/* Cone k = 0, 1, 2, 3 at (0,0), (1/2,0), (1/2,T), (0,T), on the sphere of the pillow of height T; and on the sphere of
 * the surface. */
void spherecones_of_pillow(double T, int k, Spinor w);
void spherecones_place(const SphereCones *c, int k, Spinor Z);

#endif
