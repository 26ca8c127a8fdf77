/* colourmap.h - maps from [0,1] to colours. */
#ifndef COLOURMAP_H
#define COLOURMAP_H

/* Red, green and blue in sRGB. */
typedef struct Colour {
	unsigned char r, g, b;
} Colour;

/* COLOURMAP_VIRIDIS goes from dark violet to yellow, for one sign.  COLOURMAP_DIVERGING goes from blue
 * over light grey, at 1/2, to red. */
typedef enum Colourmap { COLOURMAP_VIRIDIS, COLOURMAP_DIVERGING } Colourmap;

/* The colour of t in [0,1]: the nearest of the 256 or 257 of the map, which lie evenly. */
Colour colourmap(Colourmap map, double t);

#endif
