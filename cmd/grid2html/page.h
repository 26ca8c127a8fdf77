/* page.h - surfaces as one HTML file that needs no network. */
#ifndef CMD_HTMLPAGE_H
#define CMD_HTMLPAGE_H

#include <stdio.h>

#include "shown.h"

/* Writes the page: three.js and its OrbitControls from the folder `three`, the surfaces as base64 arrays, and the
 * script that shows them.  b may be NULL.  channel: the field that is shown first, or NULL.  Dies if the library is
 * not there. */
void page_write(FILE *f, const char *three, const Shown *a, const Shown *b, const char *channel);

#endif
