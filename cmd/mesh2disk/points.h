/* points.h - the option --points of mesh2disk. */
#ifndef CMD_POINTS_H
#define CMD_POINTS_H

#include "../../lib/mesh/mesh.h"

/* If s has no faces: makes them if wanted, with a note of their number and of the largest radius of a
 * circle through the corners of one; or dies and names --points.  If s has faces: does nothing, and notes
 * that --points had nothing to do. */
void points_to_faces(const char *name, int wanted, Soup *s);

#endif
