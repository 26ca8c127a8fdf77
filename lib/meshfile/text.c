/* text.c - a file that grows in memory. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../base/chart.h"
#include "../mesh/channel.h"
#include "facts.h"
#include "writepriv.h"

int
text_room(Text *t)
{
	char *p;

	if (t->cap - t->n > TEXT_MAX)
		return 1;
	if (t->cap > SIZE_MAX / 4 || !(p = realloc(t->p, 2*t->cap + 4096)))
		return 0;
	t->p = p;
	t->cap = 2*t->cap + 4096;
	return 1;
}

void
text_bytes(Text *t, uint64_t w, int n)
{
	for (; n > 0; n--, w >>= 8)
		t->p[t->n++] = (char)(w & 0xff);
}

/* Appends x, with the fewest of 15 to 17 digits that read back as x, and the character `after`. */
static void
number(Text *t, double x, char after)
{
	char *s = t->p + t->n;
	int digits = 15;

	do
		snprintf(s, 32, "%.*g", digits, x);
	while (strtod(s, NULL) != x && ++digits <= 17);
	t->n += strlen(s);
	t->p[t->n++] = after;
}

void
text_words(Text *t, const char *s)
{
	size_t n = strlen(s);

	memcpy(t->p + t->n, s, n);
	t->n += n;
}

void
text_int(Text *t, int i)
{
	char digit[12];
	int n = 0;

	do
		digit[n++] = (char)('0' + i % 10);
	while ((i /= 10) > 0);
	while (n > 0)
		t->p[t->n++] = digit[--n];
}

int
text_corners(const Soup *s, int f, const int **v)
{
	*v = s->idx + (s->first ? (size_t)s->first[f] : 3*(size_t)f);
	return s->first ? s->first[f+1] - s->first[f] : 3;
}

int
text_lines(Text *t, const double *x, int nv, int n, const char *before)
{
	size_t i;
	int c;

	for (i = 0; i < (size_t)nv; i++) {
		if (!text_room(t))
			return MESH_ENOMEM;
		text_words(t, before);
		for (c = 0; c < n; c++)
			number(t, x[(size_t)n*i + (size_t)c], c < n - 1 ? ' ' : '\n');
	}
	return 0;
}

int
text_facts(Text *t, const Soup *s, const char *before)
{
	char key[FACT_KEY], value[FACT_VALUE];
	const char *facts = s->facts;

	while ((facts = fact_next(facts, key, value))) {
		if (!text_room(t))
			return MESH_ENOMEM;
		t->n += (size_t)snprintf(t->p + t->n, TEXT_MAX, "%slhgrid fact %s %s\n", before, key, value);
	}
	return text_room(t) ? 0 : MESH_ENOMEM;
}

void
text_modulus(Text *t, const Soup *s, const char *before)
{
	if (!channel_find(&s->channels, MESH_UV) || !(s->T > 0))
		return;
	text_words(t, before);
	text_words(t, "lhgrid T ");
	number(t, s->T, '\n');
	if (!s->chart || s->chart == &CHART_RECTANGLE)
		return;
	text_words(t, before);
	text_words(t, "lhgrid chart ");
	text_words(t, s->chart->name);
	text_words(t, "\n");
}
