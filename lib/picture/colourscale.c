/* colourscale.c - which value has which colour. */
#include <math.h>
#include <stdlib.h>

#include "colourscale.h"

static int
increasing(const void *a, const void *b)
{
	const double x = *(const double *)a, y = *(const double *)b;

	return (x > y) - (x < y);
}

double
colourscale_quantile(size_t n, const double *sorted, double share)
{
	return sorted[(size_t)(share*(double)(n - 1) + 0.5)];
}

static double
end_value(size_t n, const double *sorted, ColourEnd e)
{
	return e.percent ? colourscale_quantile(n, sorted, e.value/100) : e.value;
}

void
colourscale_fit(ColourScale *s, size_t n, double *x, ColourEnd low, ColourEnd high)
{
	qsort(x, n, sizeof *x, increasing);
	s->low = end_value(n, x, low);
	s->high = end_value(n, x, high);
	if (low.percent && high.percent && s->low == s->high) {
		s->low = x[0];
		s->high = x[n-1];
	}
	if (s->map == COLOURMAP_DIVERGING) {
		s->high = fmax(fabs(s->low), fabs(s->high));
		s->low = s->high > 0 ? -s->high : 0;     /* -0 would be printed */
	}
}

double
colourscale_place(const ColourScale *s, double x)
{
	double t;

	if (!(s->low < s->high))
		return 0.5;
	if (!(x > s->low))
		return 0;
	if (!(x < s->high))
		return 1;
	if (s->log)
		t = (log(x) - log(s->low))/(log(s->high) - log(s->low));
	else                                    /* halves, because high - low may overflow */
		t = (x/2 - s->low/2)/(s->high/2 - s->low/2);
	return t > 0 ? fmin(t, 1) : 0;
}

Colour
colourscale_colour(const ColourScale *s, double x)
{
	return isnan(x) ? (Colour){ 128, 128, 128 } : colourmap(s->map, colourscale_place(s, x));
}
