/* pageopt.c - the options of lh2png. */
#include <stdlib.h>

#include "../shared/cmd.h"
#include "pageopt.h"

void
pageopt_init(PageOpt *o)
{
	*o = (PageOpt){ .low = { 1, 1 }, .high = { 99, 1 }, .map = -1 };
}

/* Reads a number, or a percentage 0%..100%, and what follows it.  Returns the rest of s after it, NULL
 * if there is no such number. */
static const char *
read_end(const char *s, ColourEnd *e)
{
	char *end;

	e->value = strtod(s, &end);
	if (end == s || !(e->value >= -1e300 && e->value <= 1e300))
		return NULL;
	e->percent = *end == '%';
	if (e->percent && !(e->value >= 0 && e->value <= 100))
		return NULL;
	return end + e->percent;
}

void
pageopt_range(PageOpt *o, const char *s)
{
	const char *rest = read_end(s, &o->low);

	if (rest)
		rest = *rest == ',' ? read_end(rest + 1, &o->high) : NULL;
	if (!rest || *rest || (o->low.percent == o->high.percent && !(o->low.value < o->high.value)))
		misuse("--range=%s: need LOW,HIGH, each a number or a percentage in 0%%..100%%, LOW below HIGH", s);
}

void
pageopt_check(const PageOpt *o)
{
	if (o->bare && o->axes)
		misuse("--axes: --bare leaves out all numbers");
	if (o->log && o->map == COLOURMAP_DIVERGING)
		misuse("--log: a diverging map is centred on 0, which has no logarithm");
	if (o->log && !o->low.percent && !(o->low.value > 0))
		misuse("--range: with --log LOW must be positive");
}
