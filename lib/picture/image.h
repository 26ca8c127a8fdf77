/* image.h - an array of pixels, with rectangles and text. */
#ifndef IMAGE_H
#define IMAGE_H

#include "colourmap.h"

typedef struct Image {
	int     w, h;
	Colour *px;             /* [h][w], row 0 at the top */
} Image;

/* The most bytes of an image: libpng's simplified writer counts them in 32 bits. */
#define IMAGE_MOST 0x7fffffffu

enum {
	IMAGE_ENOMEM = -1,
	IMAGE_ELARGE = -2       /* more than IMAGE_MOST bytes */
};

/* A white image.  Returns 0 or an IMAGE_ code. */
int image_init(Image *m, int w, int h);
void image_free(Image *m);

/* What lies outside the image is left out. */
void image_rectangle(Image *m, int x, int y, int w, int h, Colour c);

/* Writes a line in black.  (x,y) is the upper left corner of its first character, which is zoom times
 * as large as font.h says. */
void image_text(Image *m, int x, int y, int zoom, const char *text);

#endif
