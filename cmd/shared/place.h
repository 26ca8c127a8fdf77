/* place.h - the channels place.x place.y place.z: positions that lhfft filters with lambda and H. */
#ifndef CMD_PLACE_H
#define CMD_PLACE_H

#include "cmd.h"

extern const char *const PLACE[3];

/* Sets f to the three fields of g and returns 1; or returns 0 if g has none.  Dies if they are not
 * complete or out of range (range.h). */
int  place_of(const CmdInput *in, const Lhg *g, double *f[3]);

/* Whether g has a place, and a start on a lattice.  With `change` this start becomes the place: the same
 * positions on all nodes. */
int  place_starts(const CmdInput *in, Lhg *g, int change);

/* Removes the place of g, and the metadata scale and relief that say how it was filtered. */
void place_drop(Lhg *g);

#endif
