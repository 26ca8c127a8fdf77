/* history.c - the past of a grid that has two parents. */
#include <stdlib.h>
#include <string.h>

#include "../shared/cmd.h"
#include "history.h"

/* Calls use for each line of s, without its newline. */
static void
each_line(const char *s, void (*use)(char *line, const void *ctx, Lhg *g), const void *ctx, Lhg *g)
{
	char *copy = s ? strdup(s) : NULL, *line, *end;

	if (s && !copy)
		die("no memory for the history");
	for (line = copy; line && (end = strchr(line, '\n')); line = end + 1) {
		*end = '\0';
		use(line, ctx, g);
	}
	free(copy);
}

static void
add_step(char *line, const void *mark, Lhg *g)
{
	size_t n = strlen(line) + 8;
	char *step = cmd_alloc(n, 1);

	snprintf(step, n, "%s: %s", (const char *)mark, line);
	if (lhg_note(g, step))
		die("no memory for the history");
	free(step);
}

static void
add_equal(char *line, const void *other, Lhg *g)
{
	char *value = strchr(line, ' '), *theirs = cmd_alloc(strlen(line) + 2, 1);

	if (value) {
		*value++ = '\0';
		if (lhg_getmeta(other, line, theirs, strlen(value) + 2) && strcmp(theirs, value) == 0)
			cmd_meta(g, line, "%s", value);
	}
	free(theirs);
}

void
history_merge(const Lhg *a, const Lhg *b, Lhg *g)
{
	each_line(a->meta, add_equal, b, g);
	each_line(a->hist, add_step, "A", g);
	each_line(b->hist, add_step, "B", g);
}
