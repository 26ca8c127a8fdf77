/* spread.c - how the samples of a channel are spread. */
#include <stdlib.h>
#include <string.h>

#include "../../lib/picture/colourscale.h"
#include "../shared/cmd.h"
#include "spread.h"

enum { BAR = 40 };                      /* columns of the longest bar */

static int
ascending(const void *a, const void *b)
{
	double x = *(const double *)a, y = *(const double *)b;

	return (x > y) - (x < y);
}

/* The part of low .. high, which must differ, that x lies in.  Halves are taken, since high - low may
 * overflow. */
static int
bin_of(const Spread *s, double x)
{
	const int k = (int)((x/2 - s->low/2)/(s->high/2 - s->low/2)*SPREAD_BINS);

	return k < SPREAD_BINS ? k : SPREAD_BINS - 1;
}

Spread
spread_of(const LhgChannel *c)
{
	double *x = cmd_alloc(c->n, sizeof *x);
	Spread s = { .below = 0 };
	size_t i;

	memcpy(x, c->f, c->n*sizeof *x);
	qsort(x, c->n, sizeof *x, ascending);
	s.low = colourscale_quantile(c->n, x, .01);
	s.median = colourscale_quantile(c->n, x, .5);
	s.high = colourscale_quantile(c->n, x, .99);
	for (i = 0; i < c->n; i++)
		if (x[i] < s.low)
			s.below++;
		else if (x[i] > s.high)
			s.above++;
		else
			s.bin[s.high > s.low ? bin_of(&s, x[i]) : 0]++;
	free(x);
	return s;
}

static void
bar(FILE *f, size_t n, size_t most)
{
	size_t k, columns = (size_t)((double)n/(double)most*BAR + .5);

	for (k = 0; k < columns; k++)
		putc('#', f);
	putc('\n', f);
}

void
spread_text(FILE *f, const Spread *s)
{
	const double step = s->high/SPREAD_BINS - s->low/SPREAD_BINS;
	size_t most = 1;
	int k;

	for (k = 0; k < SPREAD_BINS; k++)
		most = s->bin[k] > most ? s->bin[k] : most;
	fprintf(f, "    1 %% %.6g  median %.6g  99 %% %.6g\n", s->low, s->median, s->high);
	fprintf(f, "    %24s %8zu\n", "below", s->below);
	for (k = 0; k < SPREAD_BINS && (k == 0 || step > 0); k++) {
		fprintf(f, "    %11.4g ..%11.4g %8zu ", s->low + k*step, s->low + (k+1)*step, s->bin[k]);
		bar(f, s->bin[k], most);
	}
	fprintf(f, "    %24s %8zu\n", "above", s->above);
}

void
spread_json(FILE *f, const Spread *s)
{
	int k;

	fprintf(f, ", \"p01\": %.17g, \"median\": %.17g, \"p99\": %.17g, \"below\": %zu, \"above\": %zu, \"histogram\": [",
		s->low, s->median, s->high, s->below, s->above);
	for (k = 0; k < SPREAD_BINS; k++)
		fprintf(f, "%s%zu", k ? ", " : "", s->bin[k]);
	putc(']', f);
}
