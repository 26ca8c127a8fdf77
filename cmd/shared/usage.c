/* usage.c - prints a usage text in lines of at most 80 columns.
 *
 * A usage text holds lists of formats, and the options that all commands have, so its lines get their
 * length only when it is printed.  It consists of blocks: an option or a name with its meaning, whose
 * further lines are indented by 20 and more; lines that are equally indented, by more than 2; lines
 * without indentation, up to one that ends in a full stop or a colon; and single lines, as the example.  A block
 * without a line that is too long is printed as it is written; otherwise its words are filled into
 * new lines. */
#include <stdio.h>
#include <string.h>

#include "cmd.h"
#include "private.h"

enum { WIDTH = 80, MEANING = 20 };

static const char COMMON[] =
"  -j, --threads=N    at most N threads [OMP_NUM_THREADS, or one for each processor]\n"
"      --progress=auto|always|never|json  on stderr what is being done, and for how long still:\n"
"                     auto: on a terminal, after a second [auto]\n"
"  -q, --quiet        no notes on stderr\n"
"  -v, --verbose      more details on stderr\n"
"  -h, --help         print this text\n"
"      --version      print the version\n";

static size_t
indent(const char *line)
{
	return strspn(line, " ");
}

/* The length of the line at s, with its LF if it has one. */
static size_t
line_length(const char *s)
{
	size_t n = strcspn(s, "\n");

	return n + (s[n] == '\n');
}

static int
begins(const char *s, const char *word)
{
	return strncmp(s, word, strlen(word)) == 0;
}

/* Whether the line at s goes on with the block that began with the line at first. */
static int
goes_on(const char *first, const char *s)
{
	if (indent(s) >= MEANING)
		return 1;
	if (indent(s) != indent(first) || s[indent(s)] == '-')
		return 0;
	if (indent(s) > 0)
		return indent(s) > 2;
	return s[-2] != '.' && s[-2] != ':' && !begins(s, "Example: ") && !begins(first, "Example: ") &&
	    !begins(first, "usage: ");
}

/* The column where the second line of a block begins: under the meaning of an option or a name, under
 * the arguments of a usage line, or under the first line. */
static size_t
hanging(const char *first, const char *second)
{
	if (begins(first, "usage: "))
		return 13;
	if (indent(second) >= MEANING)
		return indent(second);
	if (indent(first) > 0 && (first[indent(first)] == '-' || indent(first) == 2))
		return MEANING + 1;
	return indent(first);
}

/* Fills the n bytes of a block into lines.  Between words of one line the blanks are kept; where two
 * lines are joined there is one, after a full stop two. */
static void
fill(FILE *f, const char *s, size_t n, size_t hang)
{
	const char *end = s + n, *word;
	size_t column = 0, blanks, len, lf;

	for (; s < end; s = word + len) {
		for (word = s, lf = 0; word < end && (*word == ' ' || *word == '\n'); word++)
			lf |= *word == '\n';
		for (len = 0; word + len < end && word[len] != ' ' && word[len] != '\n'; len++)
			;
		if (!len)
			break;
		blanks = lf ? 1 + (s[-1] == '.') : (size_t)(word - s);
		if (column > hang && column + blanks + len > WIDTH)
			column = 0, fprintf(f, "\n%*s", (int)(blanks = hang), "");
		else
			fprintf(f, "%*s", (int)blanks, "");
		fwrite(word, 1, len, f);
		column += blanks + len;
	}
	putc('\n', f);
}

void
usage_print(FILE *f, const char *text)
{
	size_t n, line, longest;
	const char *first;

	for (first = text; *first; first += n) {
		longest = n = line_length(first);
		if (begins(first, CMD_USAGE_COMMON)) {
			usage_print(f, COMMON);
			continue;
		}
		while (first[n] && goes_on(first, first + n) && !begins(first + n, CMD_USAGE_COMMON)) {
			line = line_length(first + n);
			longest = line > longest ? line : longest;
			n += line;
		}
		if (longest > WIDTH + 1)
			fill(f, first, n, hanging(first, first + line_length(first)));
		else
			fwrite(first, 1, n, f);
	}
}
