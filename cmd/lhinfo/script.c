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

/* Writes the step at s without the operands that stand for results of earlier steps; `files` temporary files
 * from number `file` on replace them, none if the input is a pipe. */
static void
write_later_step(const Script *c, const char *s, int file, int files)
{
	const char *end = word_end(s);
	int k;

	fprintf(c->f, "%.*s", (int)(end - s), s);
	while (*end == ' ' && end[1] != ' ') {
		s = end + 1;
		end = word_end(s);
		if (strncmp(s, "--", 2) == 0 && end - s > 2)
			fprintf(c->f, " %.*s", (int)(end - s), s);
		else
			break;
	}
	for (k = 0; k < files; k++)
		fprintf(c->f, " \"$tmp/%d\"", file + k);
}

/* The number of operands of the step at s. */
static int
operands(const char *s)
{
	const char *end = word_end(s), *last = comment(s);
	int n = 0, after = 0;

	while (end < last && *end == ' ') {
		s = end + 1;
		end = word_end(s);
		n += after || strncmp(s, "--", 2) != 0;
		after |= end - s == 2 && strncmp(s, "--", 2) == 0;
	}
	return n;
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

/* The end of the lines at s, before `end`, that have this mark behind the first `skip` bytes. */
static const char *
marked(const char *s, const char *end, size_t skip, const char *mark)
{
	while (s < end && strncmp(s + skip, mark, strlen(mark)) == 0)
		s = after_line(s);
	return s;
}

static void write_lines(Script *c, const char *s, const char *end, size_t skip);

/* Writes the inputs of a merge, whose lines come first in s .. end, each as a pipeline into a temporary file
 * of its own.  Returns the line after them, and the number of inputs in *n, 0 if there is no merge. */
static const char *
write_inputs(Script *c, const char *s, const char *end, size_t skip, int *n)
{
	char mark[CMD_MARKLEN];
	const char *a = s, *b;
	int file = c->files;

	for (*n = 0; cmd_mark(*n, mark), (b = marked(a, end, skip, mark)) > a; a = b)
		++*n;
	c->files += *n;
	for (*n = 0, a = s; cmd_mark(*n, mark), (b = marked(a, end, skip, mark)) > a; a = b) {
		write_lines(c, a, b, skip + strlen(mark));
		fprintf(c->f, " >\"$tmp/%d\"\n", file + (*n)++);
	}
	return a;
}

/* Writes the lines at s .. end, without their first `skip` bytes, as a pipeline.  An input without history
 * has no lines, and cannot be made again. */
static void
write_lines(Script *c, const char *s, const char *end, size_t skip)
{
	int file = c->files, inputs;
	const char *first = write_inputs(c, s, end, skip, &inputs), *line, *at;
	char mark[CMD_MARKLEN];

	cmd_mark(1, mark);
	if (first < end)
		check_complete(c, first + skip);
	if ((inputs && (first == end || operands(first + skip) != inputs)) || strncmp(first + skip, mark, strlen(mark)) == 0)
		die("%s: an input of a merge has no history", c->name);
	for (line = first; line < end; line = after_line(line)) {
		check_complete(c, line + skip);
		at = comment(line);
		if (line > first || inputs)
			write_later_step(c, line + skip, file, line == first ? inputs : 0);
		else
			fprintf(c->f, "%.*s", (int)(at - line - skip), line + skip);
		if (after_line(line) < end)
			fprintf(c->f, " |%.*s\n    ", (int)strcspn(at, "\n"), at);
	}
}

void
script_write(FILE *f, const char *name, const Lhg *g, int *folder)
{
	Script c = { f, name, 0 };
	char mark[CMD_MARKLEN];

	if (!g->hist || !*g->hist)
		die("%s: no history", name);
	cmd_mark(0, mark);
	if (!*folder && strncmp(g->hist, mark, strlen(mark)) == 0)
		*folder = fputs("tmp=$(mktemp -d)\ntrap 'rm -rf \"$tmp\"' EXIT\n", f) >= 0;
	write_lines(&c, g->hist, g->hist + strlen(g->hist), 0);
	putc('\n', f);
}
