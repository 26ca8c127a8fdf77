/* deviation.h - how far a computed surface is from the one that its lambda and H belong to. */
#ifndef DEVIATION_H
#define DEVIATION_H

#include "../shared/cmd.h"

/* If g has the place of an unfiltered surface, compares phi [3][nv][nu] with it, sets the metadatum
 * deviation to the largest distance of a node over sqrt(area of the place), and prints a note if that
 * is above 1 %. */
void deviation(const CmdInput *in, Lhg *g, const double *phi);

#endif
