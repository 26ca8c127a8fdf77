/* corneropt.h - the option --corners of mesh2rect. */
#ifndef CMD_CORNEROPT_H
#define CMD_CORNEROPT_H

#include "../../lib/mesh/mesh.h"

/* arg as places in the boundary loop of d, or die.  NULL and "auto" choose by shape;
 * "I,J,K,L" are vertices by their number in the file; "x,y,z;x,y,z;x,y,z;x,y,z" are points,
 * each standing for the nearest vertex of the boundary; anything else is a file that holds
 * four numbers or four points. */
void opt_corners(const char *arg, const Disk *d, int corner[4]);

#endif
