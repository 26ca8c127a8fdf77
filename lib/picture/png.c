/* png.c - an image as the bytes of a PNG file, by the simplified writer of libpng 1.6. */
#include <png.h>
#include <stdlib.h>
#include <string.h>

#include "png.h"

int
png_bytes(const Image *m, unsigned char **bytes, size_t *n)
{
	png_image p;
	png_alloc_size_t size;

	memset(&p, 0, sizeof p);
	p.version = PNG_IMAGE_VERSION;
	p.width = (png_uint_32)m->w;
	p.height = (png_uint_32)m->h;
	p.format = PNG_FORMAT_RGB;
	size = PNG_IMAGE_PNG_SIZE_MAX(p);
	if (!(*bytes = malloc(size)))
		return IMAGE_ENOMEM;
	if (!png_image_write_to_memory(&p, *bytes, &size, 0, m->px, 0, NULL)) {
		png_image_free(&p);
		free(*bytes);
		*bytes = NULL;
		return IMAGE_ENOMEM;
	}
	*n = size;
	return 0;
}
