/* merge.c - metadata and history of a grid that is made of several. */
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

	snprintf(step, n, "%s%s", (const char *)mark, line);
	if (lhg_note(g, step))
		die("no memory for the history");
	free(step);
}

/* Adds the line "key value" of the first grid to the metadata of g if all others have the same value. */
static void
add_equal(char *line, const void *morph, Lhg *g)
{
	const Morph *m = morph;
	char *value = strchr(line, ' '), *its = cmd_alloc(strlen(line) + 2, 1);
	int equal = value != NULL, k;

	if (value)
		*value++ = '\0';
	for (k = 1; k < m->n && equal; k++)
		equal = lhg_getmeta(&m->s[k].g, line, its, strlen(value) + 2) && strcmp(its, value) == 0;
	if (equal)
		cmd_meta(g, line, "%s", value);
	free(its);
}

static void
add_warped(const Morph *m, const double *w, Lhg *g)
{
	char value[LHG_KEYLEN], worst[LHG_KEYLEN];
	double mean, most, largest = -1;
	int k;

	for (k = 0; k < m->n; k++) {
		if (w[k] == 0 || !lhg_getmeta(&m->s[k].g, "warped", value, sizeof value))
			continue;
		most = sscanf(value, "%lf %lf", &mean, &most) == 2 ? most : 0;
		if (most > largest) {
			largest = most;
			strcpy(worst, value);
		}
	}
	lhg_setmeta(g, "warped", NULL);
	if (largest >= 0)
		cmd_meta(g, "warped", "%s", worst);
}

void
merge_text(const Morph *m, const double *w, Lhg *g)
{
	char mark[CMD_MARKLEN];
	int k;

	each_line(m->s->g.meta, add_equal, m, g);
	add_warped(m, w, g);
	for (k = 0; k < m->n; k++) {
		cmd_mark(k, mark);
		each_line(m->s[k].g.hist, add_step, mark, g);
	}
}
