/* chart.c - the kinds of charts. */
#include <stddef.h>
#include <string.h>

#include "chart.h"

static int
wrap(int i, int n)
{
	return (i%n + n)%n;
}

static int
sock_beyond(Chart g, int *i, int *j)
{
	int out = *j < 0;

	if (out) {
		*j = -1 - *j;
		*i = g.nu - 1 - *i;
	}
	*i = wrap(*i, g.nu);
	return out ? -1 : 1;
}

const ChartKind CHART_RECTANGLE = { "rectangle", .joined = { { 0, 0 }, { 0, 0 } }, .beyond = NULL };
const ChartKind CHART_SOCK = { "sock", .joined = { { 1, 1 }, { 1, 0 } }, .beyond = sock_beyond };

const ChartKind *
chart_kind(const char *name)
{
	static const ChartKind *const kind[] = { &CHART_RECTANGLE, &CHART_SOCK };
	size_t i;

	for (i = 0; i < sizeof kind/sizeof *kind; i++)
		if (strcmp(name, kind[i]->name) == 0)
			return kind[i];
	return NULL;
}
