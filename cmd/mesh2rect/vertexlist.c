/* vertexlist.c - lists of vertex numbers or points. */
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../shared/cmd.h"
#include "vertexlist.h"

static const char digits[] = "0123456789.+-eE", marks[] = VERTEXLIST_MARKS;

/* Skips the separator of two numbers: blanks with at most one comma, or, at the end of a point, a
 * semicolon or line ends.  Returns 2 at the end of a point, 1 between other numbers, 0 for an
 * error. */
static int
skip_separator(const char **s)
{
	size_t n = strspn(*s, marks), i;
	int comma = 0, semicolon = 0, line = 0;

	for (i = 0; i < n; i++) {
		comma += (*s)[i] == ',';
		semicolon += (*s)[i] == ';';
		line += (*s)[i] == '\n';
	}
	*s += n;
	return comma + semicolon > 1 ? 0 : semicolon || line ? 2 : 1;
}

int
vertexlist(const char *s, int count, VertexList *g)
{
	int sep = 1, points = 1;
	char *end;

	s += strspn(s, " \t\r\n");
	for (g->n = 0; *s; g->n++) {
		if (g->n == VERTEXLIST_MOST || strspn(s, digits) == 0)
			return 0;
		if (g->n > 0)
			points &= (sep == 2) == (g->n%3 == 0);
		g->x[g->n] = strtod(s, &end);
		if (end == s || (size_t)(end - s) != strspn(s, digits) || !isfinite(g->x[g->n]))
			return 0;
		s = end;
		if (s[strspn(s, " \t\r\n")] == '\0')
			s += strlen(s);
		else if (strspn(s, marks) == 0 || !(sep = skip_separator(&s)) || !*s)
			return 0;
	}
	return g->n == count || (g->n == 3*count && points);
}

int
vertexlist_number(const Disk *d, const char *what, const char *of, double x)
{
	if (!(x >= 0 && x <= INT_MAX && floor(x) == x))
		die("%s %g is not the number of a vertex", what, x);
	if (x >= d->nfile || d->became[(int)x] < 0)
		die("%s %.0f is not a vertex of %s", what, x, of);
	return d->became[(int)x];
}
