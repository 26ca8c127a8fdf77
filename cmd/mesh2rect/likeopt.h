/* likeopt.h - the options --like and --like-reversed of mesh2rect. */
#ifndef CMD_LIKEOPT_H
#define CMD_LIKEOPT_H

#include "../../lib/mesh/mesh.h"

/* Sets corner to the indices in d->loop of the corners that correspond to those of the grid in path,
 * or dies.
 *
 * reversed  the normal of d, and so the direction of its boundary, may be reversed; it is
 *           reversed if the outlines are then closer
 *
 * Returns the distance of the outlines of the two boundaries (curvematch.h, outline.h). */
double opt_like(const char *path, int reversed, Disk *d, int corner[4]);

#endif
