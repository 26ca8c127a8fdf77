/* size.h - the sizes of the two surfaces of a morph. */
#ifndef CMD_SIZE_H
#define CMD_SIZE_H

#include "morph.h"

/* Scales B to the area of A, about the origin: its channels, its border, its matched points.  With
 * scaled 0 nothing changes, and sizes more than a factor of 2 apart are noted. */
void size_match(Morph *m, int scaled);

#endif
