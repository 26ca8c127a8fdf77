/* script.c - the history of a grid as a script for a shell. */
#include <string.h>

#include "../shared/cmd.h"
#include "script.h"

typedef struct Script {
	FILE       *f;
	const char *name;       /* of the input, for messages */
	int         files;      /* temporary files so far */
} Script;

static const char *
after_line(const char *s)
{
	return s + strcspn(s, "\n") + 1;
}

/* The end of the word at s: a blank or LF outside of quotes. */
static const char *
word_end(const char *s)
{
	int single = 0, twice = 0;

	for (; *s && *s != '\n' && (single || twice || *s != ' '); s++)
		if (*s == '\'')
			single = !single;
		else if (*s == '"' && !single)
			twice = !twice;
		else if (*s == '\\' && !single && !twice && s[1] != '\n')
			s++;
	return s;
}

/* Writes the step at s without the operands that stand for results of earlier steps; file: the number
 * of the first of two temporary files that replace them, or -1 if the input is a pipe. */
static void
write_later_step(const Script *c, const char *s, int file)
{
	const char *end = word_end(s);

	fprintf(c->f, "%.*s", (int)(end - s), s);
	while (*end == ' ' && end[1] != ' ') {
		s = end + 1;
		end = word_end(s);
		if (strncmp(s, "--", 2) == 0 && end - s > 2)
			fprintf(c->f, " %.*s", (int)(end - s), s);
		else
			break;
	}
	if (file >= 0)
		fprintf(c->f, " \"$tmp/%d\" \"$tmp/%d\"", file, file + 1);
}

/* The comment with the version at the end of the step at s, or the end of the line. */
static const char *
comment(const char *s)
{
	const char *end = s + strcspn(s, "\n"), *at;

	for (at = end; at > s; at--)
		if (strncmp(at, "  # lhgrid ", 11) == 0)
			return at;
	return end;
}

static void
check_complete(const Script *c, const char *s)
{
	const char *at = comment(s);

	if (strncmp(s, "# earlier steps: ", 17) == 0)
		die("%s: the oldest steps of the history are left out (LHG.md 2.4)", c->name);
	if (at - s >= 4 && strncmp(at - 4, " ...", 4) == 0)
		die("%s: a step of the history is cut off (LHG.md 2.4)", c->name);
}

/* The end of the lines at s, before `end`, that have this mark behind `depth` others. */
static const char *
marked(const char *s, const char *end, int depth, const char *mark)
{
	while (s < end && strncmp(s + 3*depth, mark, 3) == 0)
		s = after_line(s);
	return s;
}

static void write_lines(Script *c, const char *s, const char *end, int depth);

/* Writes the lines at s .. end as a pipeline into temporary file number `file`.  Without lines the
 * grid had no history, and cannot be made again. */
static void
write_input(Script *c, const char *s, const char *end, int depth, int file)
{
	if (s == end)
		die("%s: an input of a merge has no history", c->name);
	write_lines(c, s, end, depth);
	fprintf(c->f, " >\"$tmp/%d\"\n", file);
}

static void
write_lines(Script *c, const char *s, const char *end, int depth)
{
	const char *a = marked(s, end, depth, "A: "), *b = marked(a, end, depth, "B: "), *line, *at;
	int file = -1;

	if (b > s) {
		file = c->files;
		c->files += 2;
		write_input(c, s, a, depth + 1, file);
		write_input(c, a, b, depth + 1, file + 1);
	}
	for (line = b; line < end; line = after_line(line)) {
		check_complete(c, line + 3*depth);
		at = comment(line);
		if (line > b || file >= 0)
			write_later_step(c, line + 3*depth, line == b ? file : -1);
		else
			fprintf(c->f, "%.*s", (int)(at - line) - 3*depth, line + 3*depth);
		if (after_line(line) < end)
			fprintf(c->f, " |%.*s\n    ", (int)strcspn(at, "\n"), at);
	}
}

void
script_write(FILE *f, const char *name, const Lhg *g, int *folder)
{
	Script c = { f, name, 0 };

	if (!g->hist || !*g->hist)
		die("%s: no history", name);
	if (!*folder && g->hist[0] && g->hist[1] == ':')
		*folder = fputs("tmp=$(mktemp -d)\ntrap 'rm -rf \"$tmp\"' EXIT\n", f) >= 0;
	write_lines(&c, g->hist, g->hist + strlen(g->hist), 0);
	putc('\n', f);
}
