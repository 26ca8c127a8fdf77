/* size.h - the sizes of the surfaces of a morph. */
#ifndef CMD_SIZE_H
#define CMD_SIZE_H

#include "morph.h"

/* Scales b to the area of the first grid a, about the origin: its channels, its border, its matched
 * points.  If scaled is 0, nothing changes, but a note is printed if the sizes differ by more than a
 * factor of 2. */
void size_match(const Source *a, Source *b, int scaled);

#endif
