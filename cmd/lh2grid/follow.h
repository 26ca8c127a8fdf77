/* follow.h - each frame of a stream starts from the surface of the frame before. */
#ifndef FOLLOW_H
#define FOLLOW_H

#include "../shared/cmd.h"

/* The surface of the frame before; all 0 at first. */
typedef struct Before {
	int     nu, nv;
	double *phi;            /* [3][nv][nu] */
} Before;

/* Gives g a start, start.x start.y start.z in the unit of its band or of the start it had:
 * about 33 nodes along the shorter side of the surface before, if that has the nodes of g. */
void follow(const Before *before, Lhg *g);

/* Keeps phi[3][nv][nu] for the next frame, and frees it later. */
void follow_keep(Before *before, const Lhg *g, double *phi);
void follow_end(Before *before);

#endif
