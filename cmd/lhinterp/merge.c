/* merge.c - metadata and history of a grid that is made of two. */
#include <stdlib.h>
#include <string.h>

#include "../shared/cmd.h"
#include "merge.h"

/* Calls `use` for each line of s, without its newline. */
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

/* Adds a line of a parent's history, behind its mark, to the history of g. */
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

/* Adds the line "key value" to the metadata of g if other has the same value. */
static void
add_equal(char *line, const void *other, Lhg *g)
{
	char *value = strchr(line, ' '), *its = cmd_alloc(strlen(line) + 2, 1);

	if (value) {
		*value++ = '\0';
		if (lhg_getmeta(other, line, its, strlen(value) + 2) && strcmp(its, value) == 0)
			cmd_meta(g, line, "%s", value);
	}
	free(its);
}

void
merge_text(const Lhg *a, const Lhg *b, Lhg *g)
{
	each_line(a->meta, add_equal, b, g);
	each_line(a->hist, add_step, "A", g);
	each_line(b->hist, add_step, "B", g);
}
