/* history.c - the step that a command adds to the history of its results, as text for a shell. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

#include "cmd.h"
#include "private.h"

enum {
	STEP = 3600,            /* bytes of a step: 400 less than a line, for the marks of merges */
	MOST = 16384,           /* bytes of a history, a quarter of a header */
	SUMMARYLEN = 64         /* bytes of a summary, at most */
};

static const char END[] = "  # lhgrid " CMD_VERSION, CUT[] = " ...", SUMMARY[] = "# earlier steps: ";

static struct {
	char text[STEP + 1];
	int  cut;               /* a word did not fit, so no more follow */
	int  none;              /* results have no history */
} step;

/* One line of a history. */
typedef struct Line {
	const char *s;
	size_t n;               /* bytes, with the LF */
	int    age;             /* number of its marks "A: ", "B: ", .., "AA: ", .., one for each merge */
	size_t marks;           /* bytes of these */
} Line;

void
history_begin(const char *name)
{
	snprintf(step.text, sizeof step.text, "%s", name);
}

void
history_none(void)
{
	step.none = 1;
}

/* Writes value to out, in the quotes that a shell needs.  out has room for 9 bytes for each byte of
 * value, and 17 more.  Control characters and bytes that are not UTF-8 become escapes of printf %b.
 * "$(..)" drops LFs at its end, so LFs at the end of value are taken from IFS, which is " \t\n" when
 * a shell starts. */
static void
quote(const char *value, char *out)
{
	static const char plain[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-+=.,:/%@";
	size_t n = strlen(value), i, len;
	int escaped = 0;

	for (i = 0; i < n && !escaped; i += len)
		escaped = !(len = lhg_utf8(value + i, n - i));
	if (n && !value[strspn(value, plain)]) {
		strcpy(out, value);
		return;
	}
	while (n && value[n-1] == '\n')
		n--;
	out += sprintf(out, escaped ? "\"$(printf %%b '" : "'");
	for (i = 0; i < n; i += len ? len : 1)
		if (!(len = lhg_utf8(value + i, n - i)) || (escaped && strchr("'\\!", value[i])))
			out += sprintf(out, "\\0%03o", (unsigned char)value[i]);
		else if (value[i] == '\'')
			out += sprintf(out, "'\\''");
		else
			out += sprintf(out, "%.*s", (int)len, value + i);
	out += sprintf(out, escaped ? "')" : "'");
	for (; value[n]; n++)
		out += sprintf(out, "${IFS#??}");
	if (escaped)
		strcpy(out, "\"");
}

void
history_word(const char *dashes, const char *word, const char *equals, const char *value)
{
	char *quoted = cmd_alloc(strlen(value) + 2, 9);
	size_t n = strlen(step.text), room = STEP - strlen(CUT) - strlen(END) - n;

	quoted[0] = '\0';
	if (*value || !(*dashes || *word))
		quote(value, quoted);
	if (step.cut || 1 + strlen(dashes) + strlen(word) + strlen(equals) + strlen(quoted) > room)
		step.cut = 1;
	else
		sprintf(step.text + n, " %s%s%s%s", dashes, word, equals, quoted);
	free(quoted);
}

/* Whether a line is a summary, behind any number of marks.  *counted: the number of steps that the
 * line stands for, 1 if it is no summary. */
static int
is_summary(const Line *l, unsigned long *counted)
{
	const char *s = l->s + l->marks;

	*counted = 1;
	if (strncmp(s, SUMMARY, strlen(SUMMARY)) != 0)
		return 0;
	*counted = strtoul(s + strlen(SUMMARY), NULL, 10);
	return 1;
}

void
cmd_mark(int k, char mark[CMD_MARKLEN])
{
	if (k < 26)
		snprintf(mark, CMD_MARKLEN, "%c: ", 'A' + k);
	else
		snprintf(mark, CMD_MARKLEN, "%c%c: ", 'A' + (k/26 - 1)%26, 'A' + k%26);
}

/* The bytes of the mark at s, "A: " to "ZZ: ", or 0. */
static size_t
mark_at(const char *s)
{
	size_t n = strspn(s, "ABCDEFGHIJKLMNOPQRSTUVWXYZ");

	return (n == 1 || n == 2) && strncmp(s + n, ": ", 2) == 0 ? n + 2 : 0;
}

/* The *n lines of text, as an array to be freed. */
static Line *
split(const char *text, size_t *n)
{
	size_t most = 0, i;
	const char *s;
	Line *l;

	for (s = text; *s; s++)
		most += *s == '\n';
	l = cmd_alloc(most, sizeof *l);
	for (s = text, *n = 0; *n < most; s += l[(*n)++].n) {
		l[*n] = (Line){ .s = s, .n = strcspn(s, "\n") + 1 };
		for (; (i = mark_at(s + l[*n].marks)) > 0; l[*n].marks += i)
			l[*n].age++;
	}
	return l;
}

/* The index of the oldest remaining line: a summary if there is one, otherwise the first of the lines
 * that went through the most merges. */
static size_t
oldest(const Line *l, size_t n)
{
	unsigned long counted;
	size_t i, at = n;

	for (i = 0; i < n; i++)
		if (l[i].n && is_summary(&l[i], &counted))
			return i;
	for (i = 0; i < n; i++)
		if (l[i].n && (at == n || l[i].age > l[at].age))
			at = i;
	return at;
}

/* Replaces the oldest lines of text by one line with the number of their steps and the CRC-32 of
 * their bytes, so that at most MOST bytes are left. */
static void
shorten(char *text)
{
	char *kept = cmd_alloc(strlen(text) + 1, 1), *to = kept;
	unsigned long steps = 0, counted, crc = 0;
	size_t left = strlen(text) + SUMMARYLEN, n, i, k;
	Line *l = split(text, &n);
	const char *removed = text;

	while (left > MOST) {
		k = oldest(l, n);
		is_summary(&l[k], &counted);
		steps += counted;
		left -= l[k].n;
		l[k].n = 0;
	}
	for (i = 0; i < n; i++) {
		if (!l[i].n)
			continue;
		crc = crc32(crc, (const Bytef *)removed, (uInt)(l[i].s - removed));
		removed = l[i].s + l[i].n;
		memcpy(to, l[i].s, l[i].n);
		to += l[i].n;
	}
	*to = '\0';
	sprintf(text, "%s%lu, CRC-32 %08lx\n%s", SUMMARY, steps, crc, kept);
	free(kept);
	free(l);
}

char *
history_with_step(const char *past)
{
	size_t n = past ? strlen(past) : 0;
	char *text;

	if (step.none)
		return NULL;
	text = cmd_alloc(n + STEP + SUMMARYLEN + 2, 1);
	sprintf(text, "%s%s%s%s\n", n ? past : "", step.text, step.cut ? CUT : "", END);
	if (strlen(text) > MOST)
		shorten(text);
	return text;
}
