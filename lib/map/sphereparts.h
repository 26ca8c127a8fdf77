/* sphereparts.h - parts of a surface that is mapped to the sphere, and how equal the cells of a pillow are on them.
 *
 * With cones at p_k the cells of a pillow have the areas
 *
 *   a ~ S/(|p_0 x Z| |p_1 x Z| |p_2 x Z| |p_3 x Z|),   p x Z = p[0] Z[1] - p[1] Z[0],
 *
 * for a part of area S on the sphere, at Z.  chi^2 is that of parts.h, without up to
 * 0.1 % of the surface.  doc/mathematics.md 3.9.
 */
#ifndef SPHEREPARTS_H
#define SPHEREPARTS_H

#include "../base/moebius.h"
#include "../mesh/mesh.h"

enum { SPHEREPARTS_ENOMEM = -1 };
enum { SPHEREPARTS_CONES = 4, SPHEREPARTS_FREE = 8 /* two numbers for each cone */ };

typedef struct SphereParts {
	int     n;
	double *A, *S;          /* areas on the surface, and on the unit sphere over 4 pi */
	Spinor *Z;              /* of norm 1 */
	double *ratio;          /* A/a for the last cones */
} SphereParts;

/* About `parts` parts, of equal area on the surface, of either half |z| < 1, |z| > 1 of the sphere; at most
 * PARTS_MOST (parts.h).  Z of the vertices is of norm 1.  Returns 0, or SPHEREPARTS_ENOMEM with nothing to free. */
int  sphereparts_init(SphereParts *p, const Mesh *m, Spinor *Z, int parts);
void sphereparts_free(SphereParts *p);

/* log chi^2; with its gradient g and an approximation of its Hessian that is exact where log A/a is linear.  Cone k
 * is changed to the point x + iy of the plane in which it is at 0; g[2k], g[2k+1] belong to x and y. */
double sphereparts_value(const SphereParts *p, Spinor cone[SPHEREPARTS_CONES]);
double sphereparts_derivatives(const SphereParts *p, Spinor cone[SPHEREPARTS_CONES], double g[SPHEREPARTS_FREE],
	double H[SPHEREPARTS_FREE][SPHEREPARTS_FREE]);

#endif
