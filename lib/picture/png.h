/* png.h - an image as the bytes of a PNG file. */
#ifndef PICTURE_PNG_H
#define PICTURE_PNG_H

#include <stddef.h>

#include "image.h"

/* Sets bytes[*n], to be freed: 8 bits for each of red, green and blue, sRGB, no time and no text.
 * Returns 0 or IMAGE_ENOMEM. */
int png_bytes(const Image *m, unsigned char **bytes, size_t *n);

#endif
