/* numbered.c - names of output files with a number in them, as in frame-%03d.off. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cmd.h"
#include "numbered.h"

/* Splits name into the parts before and after the number, and its width.  Returns 0 if there is no
 * number. */
static int
split(const char *name, size_t *before, int *width, const char **after)
{
	const char *s = name ? strchr(name, '%') : NULL;
	char *end;

	if (!s)
		return 0;
	*before = s - name;
	*width = strtol(s + 1, &end, 10);
	if (*end != 'd' || end - s > 4 || *width < 0 || strchr(end, '%'))
		misuse("--output=%s: need one %%d or %%03d and no other %%", name);
	*after = end + 1;
	return 1;
}

int
numbered(const char *name)
{
	const char *after;
	size_t before;
	int width;

	return split(name, &before, &width, &after);
}

const char *
numbered_name(const char *name, int i, char *out, size_t n)
{
	const char *after;
	size_t before;
	int width;

	if (!split(name, &before, &width, &after))
		return name;
	if ((size_t)snprintf(out, n, "%.*s%0*d%s", (int)before, name, width, i, after) >= n)
		die("%s: name too long", name);
	return out;
}
