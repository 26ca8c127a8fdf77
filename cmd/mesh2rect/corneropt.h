/* corneropt.h - the option --corners of mesh2rect. */
#ifndef CMD_CORNEROPT_H
#define CMD_CORNEROPT_H

#include "../../lib/mesh/mesh.h"

/* Sets corner to the indices of four corners in d->loop, or dies.  arg NULL or "auto": chosen by the
 * shape of the boundary; "I,J,K,L": vertices by their number in the file;
 * "x,y,z;x,y,z;x,y,z;x,y,z": the boundary vertices nearest to these points; anything else: the name
 * of a file with four numbers or four points. */
void opt_corners(const char *arg, const Disk *d, int corner[4]);

#endif
