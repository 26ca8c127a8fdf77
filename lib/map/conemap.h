/* conemap.h - the Moebius map from the sphere of a surface to that of a pillow. */
#ifndef CONEMAP_H
#define CONEMAP_H

#include "../base/moebius.h"

typedef struct ConeMap {
	Moebius M;              /* of determinant 1 */
	double  T;              /* height of the pillow */
} ConeMap;

/* The point of the sphere of the pillow at Z, of norm 1; and Z at that point. */
void conemap_move(const ConeMap *c, const Spinor Z, Spinor w);
void conemap_back(const ConeMap *c, const Spinor w, Spinor Z);

/* Cone k = 0, 1, 2, 3 at (0,0), (1/2,0), (1/2,T), (0,T): on the sphere of the pillow of height T, and on that of the
 * surface. */
void conemap_pillow(double T, int k, Spinor w);
void conemap_place(const ConeMap *c, int k, Spinor Z);

/* The map that takes P to the first three cones of the pillow of height T. */
void conemap_three(Spinor P[3], double T, ConeMap *c);

#endif
