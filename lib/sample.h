/* sample.h - a mapped disk sampled on the grid nodes, by scan conversion. */
#ifndef SAMPLE_H
#define SAMPLE_H

#include "chart.h"
#include "mesh.h"

enum {
	SAMPLE_ENOMEM = -1,
	SAMPLE_EHOLE  = -2      /* no triangle covers node *at */
};

/* phi at every node: inside, linear on the triangle that holds the node in the (u,v)
 * plane; on the four sides, linear along the boundary loop.  Where triangles overlap
 * (a map with turned ones) the one in which the node lies deepest is taken.  Linear in
 * triangles plus nodes.
 *
 * u, v     in   [nv] of each vertex, as rectmap gives them
 * corner   in   places in the loop
 * phi      out  phi[0], phi[1], phi[2]: x, y, z, each [g.nv][g.nu]
 *
 * Returns 0, SAMPLE_ENOMEM or SAMPLE_EHOLE. */
int sample_disk(const Disk *d, const int corner[4], const double *u, const double *v,
	Chart g, double *const phi[3], int *at);

#endif
