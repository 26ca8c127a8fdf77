/* size.h - the sizes of the two surfaces of a morph. */
#ifndef CMD_SIZE_H
#define CMD_SIZE_H

#include "morph.h"

/* Scales B to the area of A, about the origin: its channels, its border, its matched points.  If
 * scaled is 0, nothing changes, but a note is printed if the sizes differ by more than a factor of
 * 2. */
void size_match(Morph *m, int scaled);

#endif
