/* image.c - an array of pixels, with rectangles and text. */
#include <stdlib.h>
#include <string.h>

#include "font.h"
#include "image.h"

int
image_init(Image *m, int w, int h)
{
	*m = (Image){ w, h, NULL };
	if (w < 1 || h < 1 || (size_t)w > IMAGE_MOST/sizeof(Colour)/(size_t)h)
		return IMAGE_ELARGE;
	if (!(m->px = malloc((size_t)w*h*sizeof *m->px)))
		return IMAGE_ENOMEM;
	memset(m->px, 255, (size_t)w*h*sizeof *m->px);
	return 0;
}

void
image_free(Image *m)
{
	free(m->px);
	m->px = NULL;
}

void
image_rectangle(Image *m, int x, int y, int w, int h, Colour c)
{
	const int right = x + w < m->w ? x + w : m->w, bottom = y + h < m->h ? y + h : m->h;
	int i, j;

	for (j = y > 0 ? y : 0; j < bottom; j++)
		for (i = x > 0 ? x : 0; i < right; i++)
			m->px[(size_t)j*m->w + i] = c;
}

static void
draw_letter(Image *m, int x, int y, int zoom, char letter)
{
	const Colour black = { 0, 0, 0 };
	int i, j;

	for (j = 0; j < FONT_HEIGHT; j++)
		for (i = 0; i < FONT_WIDTH; i++)
			if (font_row(letter, j) >> (FONT_WIDTH - 1 - i) & 1)
				image_rectangle(m, x + i*zoom, y + j*zoom, zoom, zoom, black);
}

void
image_text(Image *m, int x, int y, int zoom, const char *text)
{
	for (; *text; text++, x += FONT_WIDTH*zoom)
		draw_letter(m, x, y, zoom, *text);
}
