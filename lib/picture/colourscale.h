/* colourscale.h - which value has which colour. */
#ifndef COLOURSCALE_H
#define COLOURSCALE_H

#include <stddef.h>

#include "colourmap.h"

/* low <= high; both positive if log is set. */
typedef struct ColourScale {
	Colourmap map;
	int       log;
	double    low, high;    /* the values at the ends of the map; beyond, its end colours */
} ColourScale;

/* One end of a range: a value, or percent of the samples below it. */
typedef struct ColourEnd {
	double value;
	int    percent;         /* not 0: value is in percent, 0..100 */
} ColourEnd;

/* The quantile of n > 0 numbers in increasing order: number share (n - 1) of them, rounded. */
double colourscale_quantile(size_t n, const double *sorted, double share);

/* Sets s->low and s->high for the n > 0 values in x, which are sorted in place.  For
 * COLOURMAP_DIVERGING the range is widened to be centred on 0.  If both ends are percentages that give
 * the same value, the range is that of all values. */
void colourscale_fit(ColourScale *s, size_t n, double *x, ColourEnd low, ColourEnd high);

/* The place of x on the scale, in [0,1]; 1/2 if low == high.  And its colour; grey if x is NaN. */
double colourscale_place(const ColourScale *s, double x);
Colour colourscale_colour(const ColourScale *s, double x);

#endif
