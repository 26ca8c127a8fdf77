/* corneropt.h - the option --corners of mesh2rect. */
#ifndef CMD_CORNEROPT_H
#define CMD_CORNEROPT_H

#include "../../lib/mesh/mesh.h"

/* Four corners, as places in the boundary loop of d, or die.  NULL and "auto" choose by shape;
 * "I,J,K,L" are vertices by their number in the file; "x,y,z;x,y,z;x,y,z;x,y,z" are the boundary
 * vertices nearest to these points; anything else is a file of four numbers or four points. */
void opt_corners(const char *arg, const Disk *d, int corner[4]);

#endif
