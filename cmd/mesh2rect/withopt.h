/* withopt.h - the option --with of mesh2rect: numbers at the vertices of the mesh. */
#ifndef CMD_WITHOPT_H
#define CMD_WITHOPT_H

#include "../../format/lhg.h"
#include "../../lib/map/conformal.h"

/* Adds the numbers of the files, separated by commas, to the channels of the mesh; dies if a file has not one for each
 * vertex, or for each of the file that mesh2disk made the mesh of; vertices that are new there get the mean of their
 * neighbours.  Call it before the disk is made. */
void with_read(const char *files, Soup *s);

/* Makes the channels of d the fields of o, whose pointers are to be freed. */
void with_fields(const Disk *d, ConformalOptions *o);

/* Writes the fields at the nodes as channels of the grid. */
void with_write(const Disk *d, const Conformal *c, Lhg *out);

#endif
