/* corneropt.c - the option --corners of mesh2rect. */
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../lib/map/corners.h"
#include "../shared/cmd.h"
#include "corneropt.h"

static const char digits[] = "0123456789.+-eE", marks[] = ",; \t\r\n";

/* Four vertex numbers or four points: x[0..n-1], n = 4 or 12. */
typedef struct Given {
	int    n;
	double x[13];
} Given;

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

/* Reads numbers and nothing else: four, or twelve with a point ending after every third.  Returns 0
 * for anything else. */
static int
parse(const char *s, Given *g)
{
	int sep = 1, points = 1;
	char *end;

	s += strspn(s, " \t\r\n");
	for (g->n = 0; *s; g->n++) {
		if (g->n == 13 || strspn(s, digits) == 0)
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
	return g->n == 4 || (g->n == 12 && points);
}

static void
read_file(const char *path, Given *g)
{
	size_t n;
	char *bytes = cmd_slurp(path, &n), *s = cmd_alloc(n + 1, 1);

	memcpy(s, bytes, n);
	s[n] = '\0';
	if (strlen(s) != n || !parse(s, g))
		die("%s: not four vertex numbers and not four points x,y,z", path);
	free(bytes);
	free(s);
}

/* Converts x, a vertex number of the file, to the vertex number in the disk; or dies. */
static int
vertex(const Disk *d, double x)
{
	if (!(x >= 0 && x <= INT_MAX && floor(x) == x))
		die("corner %g is not the number of a vertex", x);
	if (x >= d->nfile || d->became[(int)x] < 0)
		die("corner %.0f is not a vertex of the boundary", x);
	return d->became[(int)x];
}

static void
set_corners(const Given *g, const Disk *d, int corner[4])
{
	int v[4], at, k, e;

	for (k = 0; k < 4; k++)
		v[k] = g->n == 4 ? vertex(d, g->x[k]) : corners_nearest(d, g->x + 3*k);
	e = corners_given(d, v, corner, &at);
	if (e == CORNERS_EINNER)
		die("corner %d is not a vertex of the boundary", d->file[at]);
	if (e)
		die("corners %d,%d,%d,%d%s do not go round the boundary once counterclockwise",
		    d->file[v[0]], d->file[v[1]], d->file[v[2]], d->file[v[3]],
		    g->n == 4 ? "" : ", nearest to the points,");
}

void
opt_corners(const char *arg, const Disk *d, int corner[4])
{
	Given g;

	if (!arg || strcmp(arg, "auto") == 0) {
		if (corners_auto(d, corner) < 0)
			die("no memory for the boundary");
		return;
	}
	if (!parse(arg, &g)) {
		if (strpbrk(arg, marks) && strspn(arg, "0123456789.+-eE,; \t\r\n") == strlen(arg))
			misuse("--corners=%s: need four vertex numbers or four points x,y,z;..", arg);
		read_file(arg, &g);
	}
	set_corners(&g, d, corner);
}
