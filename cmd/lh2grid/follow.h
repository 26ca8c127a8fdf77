/* follow.h - each frame of a stream starts from the surface of the previous frame. */
#ifndef FOLLOW_H
#define FOLLOW_H

#include "../shared/cmd.h"

/* The surface of the previous frame; all members are 0 before the first. */
typedef struct Before {
	int     nu, nv, chart;
	double *phi;            /* [3][nv][nu] */
	double *own;            /* on a closed chart, [3][nv][nu] the start that the frame came with; or NULL */
} Before;

/* If the previous surface has the size and the chart of g, replaces the start of g by a lattice of that surface.
 * Along the shorter side the lattice has 33 to 64 nodes, or all if there are fewer.  Its unit is
 * that of the start or the band of g.  A closed surface is still placed by the start that g came with,
 * before->own. */
void follow_start(Before *before, const CmdInput *in, Lhg *g);

/* follow_keep keeps phi[3][nv][nu] for the next frame; `before` owns it from then on.  follow_end
 * frees it. */
void follow_keep(Before *before, const Lhg *g, double *phi);
void follow_end(Before *before);

#endif
