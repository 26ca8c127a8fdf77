/* pillowshift.h - a map of the sphere near the identity, given at the nodes of a pillow.
 *
 * Node p of the chart g lies at a point of the sphere of its pillow (../base/pillowplane.h) and is moved to at[p].  In the
 * plane of z, and in that of 1/z, the displacement is a smooth function of the point, also at the cones; it is even under
 * the turns about them, and is interpolated by bicubic.h.  (The displacement in (u,v) is not smooth where
 * a cone moves.)
 */
#ifndef PILLOWSHIFT_H
#define PILLOWSHIFT_H

#include "../base/pillowplane.h"
#include "sphere.h"

enum { PILLOWSHIFT_ENOMEM = -1 };

typedef struct PillowShift {
	Chart       g;
	PillowPlane plane;
	double     *d[2][2];    /* real and imaginary part, [nv][nu], in the plane of z and in that of 1/z */
} PillowShift;

/* Sets at[nv][nu] to the points of the nodes, of norm 1. */
void pillowshift_nodes(Chart g, Spinor *at);

/* Returns 0, or PILLOWSHIFT_ENOMEM with nothing to free. */
int  pillowshift_init(PillowShift *s, Chart g, Spinor *at);
void pillowshift_free(PillowShift *s);

/* The point `to` to which `from` is moved, and the point that is moved to `to`, found by a fixed-point iteration; of
 * norm 1. */
void pillowshift_to(const PillowShift *s, const Spinor from, Spinor to);
void pillowshift_from(const PillowShift *s, const Spinor to, Spinor from);

#endif
