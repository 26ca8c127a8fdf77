/* spread.h - how the samples of a channel are spread. */
#ifndef CMD_SPREAD_H
#define CMD_SPREAD_H

#include <stdio.h>

#include "../../format/lhg.h"

enum { SPREAD_BINS = 12 };

typedef struct Spread {
	double low, median, high;       /* 1 % of the samples are below low, half below median, 99 % below high */
	size_t below, above;            /* samples below low and above high */
	size_t bin[SPREAD_BINS];        /* samples in equal parts of low .. high */
} Spread;

Spread spread_of(const LhgChannel *c);

/* As lines of text, with a bar for each part; or as members of a JSON object. */
void spread_text(FILE *f, const Spread *s);
void spread_json(FILE *f, const Spread *s);

#endif
