/* loss.h - reports how much of the mesh the grid of mesh2rect does not represent. */
#ifndef CMD_LOSS_H
#define CMD_LOSS_H

#include "../../format/lhg.h"
#include "../../lib/map/conformal.h"

/* Adds the data "area", "kept" and "farthest" (gridloss.h) to the metadata of out, the grid c->grid of
 * d.  Prints a note, and returns 1, if more than 1 % of the area is lost, or if a vertex of d is farther from the grid
 * than 1 % of sqrt(area).  Dies if more than the share `most` of the area is lost.  mesh: the name of
 * d in messages.  like: the grid of --like, which on a sock or a pillow sets the numbers of nodes, or NULL. */
int loss_report(Lhg *out, const char *mesh, double most, const char *like, const Disk *d, const Conformal *c);

#endif
