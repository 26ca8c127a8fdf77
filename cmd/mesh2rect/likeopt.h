/* likeopt.h - the options --like and --like-reversed of mesh2rect. */
#ifndef CMD_LIKEOPT_H
#define CMD_LIKEOPT_H

#include "../../lib/mesh/mesh.h"

/* Corners of d, as places in its loop, that correspond to those of the grid in path, or die.
 *
 * reversed  whether the normal of d may be turned, so that its boundary goes the other way
 *           round, which it is when they are nearer so
 *
 * Returns how far the outlines of the two boundaries are apart (curvematch.h, outline.h). */
double opt_like(const char *path, int reversed, Disk *d, int corner[4]);

#endif
