/* points.h - the option --points of mesh2disk. */
#ifndef CMD_POINTS_H
#define CMD_POINTS_H

#include "../../lib/mesh/mesh.h"

/* If s has no faces: if wanted, makes them, with a note of their number and of the largest radius of a
 * circle through the corners of one; otherwise dies with a message that names --points.  If s has faces:
 * only notes, if wanted, that --points had no effect. */
void points_to_faces(const char *name, int wanted, Soup *s);

#endif
