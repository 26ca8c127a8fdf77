/* corneropt.h - the option --corners of mesh2rect. */
#ifndef CMD_CORNEROPT_H
#define CMD_CORNEROPT_H

#include "../lib/mesh.h"

/* arg as places in the boundary loop of d, or die: "I,J,K,L" are vertex numbers, NULL
 * and "auto" choose by shape, anything else is a file that holds four numbers. */
void opt_corners(const char *arg, const Disk *d, int corner[4]);

#endif
