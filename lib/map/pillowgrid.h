/* pillowgrid.h - a closed surface on the nodes of a pillow.
 *
 * A node has a place on the sphere of the sampler, which is that of the pillow (../base/pillowplane.h) of the height with
 * which the cones were chosen.  At first it is the point of the node itself; polishing moves it.
 */
#ifndef PILLOWGRID_H
#define PILLOWGRID_H

#include "../sample/spheresampler.h"
#include "polish.h"
#include "sphere.h"

typedef struct PillowGrid {
	Chart   g;
	Spinor *at;             /* [nv][nu] place of each node */
	double *phi[3];         /* [nv][nu] position of each node; one piece of memory */
} PillowGrid;

/* Samples s on the pillow g, whose T is the height with which its cones were chosen, nu, nv >= 6.  Returns 0 or
 * POLISH_ENOMEM. */
int  pillowgrid_init(PillowGrid *a, Chart g, const SphereSampler *s);
int  pillowgrid_alloc(PillowGrid *a, Chart g);
void pillowgrid_free(PillowGrid *a);

/* The (u,v) of n points of the sphere. */
int  pillowgrid_uv(const PillowGrid *a, int n, Spinor *point, double *u, double *v);

#endif
