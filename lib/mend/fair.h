/* fair.h - moves the vertices of patches so that they continue the surface smoothly.  Private to
 * lib/mend.
 *
 * With K the cotangent stiffness and M the lumped areas of the surface with flat patches, the
 * positions x of the patches' vertices solve
 *
 *   C1   K M^-1 K x = 0                  the least bending, position and slope continued
 *   C2   K M^-1 K M^-1 K x = 0           the least change of bending, curvature too
 *
 * in the rows of the patches' vertices, with all others held.  [M. Botsch, L. Kobbelt, An intuitive
 * framework for real-time freeform modeling, ACM Trans. Graph. 23 (2004), 630-634]
 */
#ifndef FAIR_H
#define FAIR_H

#include "sheet.h"

enum { FAIR_FLAT, FAIR_C1, FAIR_C2 };

/* Moves the vertices from number `from` on.  Mean curvature is not defined at boundary vertices: M^-1 is
 * 0 there, and the outer K leaves out triangles with a boundary vertex.
 *
 * order  in   FAIR_C1 or FAIR_C2
 *
 * Returns the order that was used, which is lower than `order` if the system of that is singular, and
 * FAIR_FLAT if nothing was moved; or MESH_ENOMEM. */
int fair(Sheet *s, int from, int order);

#endif
