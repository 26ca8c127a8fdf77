/* ticks.h - the numbers beside a colour bar. */
#ifndef TICKS_H
#define TICKS_H

#include "colourscale.h"

enum { TICKS_MOST = 64, TICKS_LABEL = 32 };

typedef struct Ticks {
	int    n;
	double value[TICKS_MOST];
	char   label[TICKS_MOST][TICKS_LABEL];
} Ticks;

/* Sets t to the two ends of the scale (one, if they are equal), and to round numbers between them: 1, 2
 * or 5 times a power of ten apart, on a logarithmic scale also those numbers themselves.  On a bar of
 * that length no two are nearer than gap.  Labels have as many digits, at least 4, as keep them within
 * a thousandth of the range. */
void ticks_set(Ticks *t, const ColourScale *s, double length, double gap);

#endif
