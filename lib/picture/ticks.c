/* ticks.c - the numbers beside a colour bar. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "ticks.h"

/* Appends x, if it lies between the ends and at least `apart` (a share of the bar) from every tick. */
static void
offer(Ticks *t, const ColourScale *s, double apart, double x)
{
	const double at = colourscale_place(s, x);
	int i;

	if (!(x > s->low && x < s->high) || t->n == TICKS_MOST)
		return;
	for (i = 0; i < t->n; i++)
		if (fabs(at - colourscale_place(s, t->value[i])) < apart)
			return;
	t->value[t->n++] = x;
}

/* The smallest of 1, 2, 5 times a power of ten that is at least x > 0. */
static double
round_step(double x)
{
	const double power = pow(10, floor(log10(x)));

	return x <= power ? power : x <= 2*power ? 2*power : x <= 5*power ? 5*power : 10*power;
}

/* Multiples of a round step: 0 first, and then from low on. */
static void
offer_multiples(Ticks *t, const ColourScale *s, double apart)
{
	const double span = s->high - s->low, step = round_step(span*apart), first = ceil(s->low/step);
	int k;

	if (!(span < INFINITY && step > 0))
		return;
	offer(t, s, apart, 0);
	for (k = 0; k < TICKS_MOST; k++)
		offer(t, s, apart, (first + k)*step);
}

/* Powers of ten, as many decades apart as the gap needs; then 2 and 5 times these. */
static void
offer_powers(Ticks *t, const ColourScale *s, double apart)
{
	const double first = floor(log10(s->low)), last = ceil(log10(s->high));
	const double step = fmax(1, ceil((log10(s->high) - log10(s->low))*apart));
	double k;

	for (k = step*floor(first/step); k <= last; k += step)
		offer(t, s, apart, pow(10, k));
	for (k = first; k <= last; k++) {
		offer(t, s, apart, 2*pow(10, k));
		offer(t, s, apart, 5*pow(10, k));
	}
}

static void
print_labels(Ticks *t, const ColourScale *s)
{
	const double error = (s->high - s->low)/1000;
	int digits, i, far = 1;

	for (digits = 4; far && digits <= 17; digits++)
		for (i = far = 0; i < t->n; i++) {
			snprintf(t->label[i], TICKS_LABEL, "%.*g", digits, t->value[i]);
			far |= !s->log && fabs(strtod(t->label[i], NULL) - t->value[i]) > error;
		}
}

void
ticks_set(Ticks *t, const ColourScale *s, double length, double gap)
{
	const double apart = gap/length;

	t->n = 0;
	t->value[t->n++] = s->low;
	if (s->low < s->high) {
		t->value[t->n++] = s->high;
		if (s->log && s->high/s->low >= 10)
			offer_powers(t, s, apart);
		else
			offer_multiples(t, s, apart);
	}
	print_labels(t, s);
}
