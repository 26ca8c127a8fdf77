/* font.h - the letters of pictures: 6 x 13 pixels for each printable ASCII character. */
#ifndef FONT_H
#define FONT_H

enum { FONT_WIDTH = 6, FONT_HEIGHT = 13 };

/* Row y of the character, 0 at the top: bit 5 is the leftmost pixel, bit 0 the rightmost.  Other
 * characters than the printable ones of ASCII look like '?'. */
unsigned font_row(char c, int y);

#endif
