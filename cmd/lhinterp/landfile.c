/* landfile.c - the file of --landmarks: two places or two points on each line. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../shared/cmd.h"
#include "landfile.h"

static const double FAR = 0.05;         /* a point is noted if it is farther from the boundary than
                                         * this fraction of the length of the boundary */

typedef struct Landmarks {
	const char *name;       /* of the file */
	int     n;
	double *place[2];       /* on A, on B */
	int    *line;
} Landmarks;

/* Reads the numbers of a line, at most 7; returns their count, or dies. */
static int
numbers(const char *name, int line, char *s, double x[7])
{
	static const char digits[] = "0123456789.+-eE";
	char *word, *end, *rest = s;
	int n = 0;

	s[strcspn(s, "#")] = '\0';
	while ((word = strtok_r(rest, " \t\r,", &rest))) {
		if (n == 7)
			return n;
		x[n] = strtod(word, &end);
		if (*end || word[strspn(word, digits)] || !isfinite(x[n]))
			die("%s: line %d: %.40s is not a number", name, line, word);
		n++;
	}
	return n;
}

static double
by_place(const Landmarks *l, int line, double r)
{
	if (!(r >= 0 && r < 4))
		die("%s: line %d: place %g is not in [0,4)", l->name, line, r);
	return r;
}

static double
by_point(const Landmarks *l, int line, const Border *b, int side, const double x[3])
{
	double d, r = border_nearest(b, x, &d);

	detail("%s: line %d: place %.6g on %c, at a distance of %.3g", l->name, line, r, "AB"[side], d);
	if (!(d <= FAR*b->s[b->n]))
		note("%s: line %d: the point is %.3g from the boundary of %c, whose length is %.3g",
		    l->name, line, d, "AB"[side], b->s[b->n]);
	return r;
}

static void
add(Landmarks *l, int line, char *s, const Border *const b[2])
{
	double x[7];
	int n = numbers(l->name, line, s, x), k;

	if (!n)
		return;
	if (n != 2 && n != 6)
		die("%s: line %d: %s%d %s, need two places or two points", l->name, line, n == 7 ? "more than " : "",
		    n == 7 ? 6 : n, n == 1 ? "number" : "numbers");
	for (k = 0; k < 2; k++)
		l->place[k][l->n] = n == 2 ? by_place(l, line, x[k]) : by_point(l, line, b[k], k, x + 3*k);
	l->line[l->n++] = line;
}

static void
check_order(const Landmarks *l)
{
	int k, i;

	if (!l->n)
		die("%s: no landmarks", l->name);
	for (k = 0; k < 2; k++)
		if ((i = matching_order(l->n, l->place[k])) < l->n)
			die("%s: line %d: place %g on %c does not lie between %g and %g, counterclockwise", l->name,
			    l->line[i], l->place[k][i], "AB"[k], l->place[k][i-1], l->place[k][0]);
}

/* Reads the landmarks from the text s, which is modified. */
static void
parse(Landmarks *l, char *s, const Border *const b[2])
{
	size_t most = 1, i;
	char *line, *end;
	int number = 1;

	for (i = 0; s[i]; i++)
		most += s[i] == '\n';
	l->place[0] = cmd_alloc(2*most, sizeof(double));
	l->place[1] = l->place[0] + most;
	l->line = cmd_alloc(most, sizeof(int));
	for (line = s; line; line = end, number++) {
		if ((end = strchr(line, '\n')))
			*end++ = '\0';
		add(l, number, line, b);
	}
	check_order(l);
}

void
landfile_match(const char *path, const Border *a, const Border *b, Matching *m)
{
	const Border *const both[2] = { a, b };
	Landmarks l = { .name = cmd_name_of(path) };
	size_t n;
	char *bytes = cmd_slurp(path, &n), *s = cmd_alloc(n + 1, 1);
	int at;

	memcpy(s, bytes, n);
	s[n] = '\0';
	if (strlen(s) != n)
		die("%s: not a text file", l.name);
	parse(&l, s, both);
	switch (matching_init(m, a, b, l.n, l.place[0], l.place[1], &at)) {
	case 0: break;
	case MATCHING_ENOMEM: die("no memory for %d landmarks", l.n);
	default: die("%s: line %d: the boundary has no length between this landmark and the next", l.name,
		l.line[at]);
	}
	free(bytes);
	free(s);
	free(l.place[0]);
	free(l.line);
}
