/* page.h - the channels of a grid as one picture. */
#ifndef CMD_PAGE_H
#define CMD_PAGE_H

#include "../../lib/picture/image.h"
#include "../shared/cmd.h"
#include "pageopt.h"

/* Draws the channels of o, in rows that are about as many as each has maps, or dies.  m is to be
 * freed by image_free. */
void page_draw(const CmdInput *in, const Lhg *g, const PageOpt *o, Image *m);

#endif
