/* loss.h - reports how much of the mesh the grid of mesh2rect does not represent. */
#ifndef CMD_LOSS_H
#define CMD_LOSS_H

#include "../../format/lhg.h"
#include "../../lib/map/conformal.h"

/* Adds the metadata area, kept and farthest of the grid of d; notes a loss or a distance above
 * 1 %; dies if more than the share `most` of the area is lost.  mesh: the name of d in messages. */
void loss_report(Lhg *out, const char *mesh, double most, const Disk *d, const Conformal *c);

#endif
