/* pageopt.h - the options of lh2png. */
#ifndef CMD_PAGEOPT_H
#define CMD_PAGEOPT_H

#include "../../lib/picture/colourscale.h"

typedef struct PageOpt {
	const char *channels;           /* "all", or names with commas between them; NULL by default */
	ColourEnd   low, high;          /* the range of the colours */
	int         log, bare, axes;
	int         map;                /* a Colourmap, or -1: by the channel */
	int         size;               /* width of a map in pixels, or 0: by the grid */
} PageOpt;

/* The defaults. */
void pageopt_init(PageOpt *o);

/* Reads the LOW,HIGH of --range, or exit 2. */
void pageopt_range(PageOpt *o, const char *s);

/* Exit 2 if the options contradict one another; to be called once, after all options. */
void pageopt_check(const PageOpt *o);

#endif
