/* corneropt.c - the option --corners of mesh2rect. */
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "../lib/corners.h"
#include "cmd.h"
#include "corneropt.h"

/* Four whole numbers, parted by commas or blanks, and nothing else. */
static int
four_numbers(const char *s, int vertex[4])
{
	char *end;
	long x;
	int k;

	for (k = 0; k < 4; k++) {
		s += strspn(s, k ? ", \t\r\n" : " \t\r\n");
		errno = 0;
		x = strtol(s, &end, 10);
		if (end == s || errno || x < 0 || x > 2147483647)
			return 0;
		vertex[k] = x;
		s = end;
	}
	return s[strspn(s, " \t\r\n")] == '\0';
}

static void
read_numbers(const char *path, int vertex[4])
{
	size_t n;
	char *bytes = cmd_slurp(path, &n), *s = cmd_alloc(n + 1, 1);

	memcpy(s, bytes, n);
	s[n] = '\0';
	if (strlen(s) != n || !four_numbers(s, vertex))
		die("%s: not four vertex numbers", path);
	free(bytes);
	free(s);
}

void
opt_corners(const char *arg, const Disk *d, int corner[4])
{
	int vertex[4], at = 0, e;

	if (!arg || strcmp(arg, "auto") == 0) {
		if (corners_auto(d, corner) < 0)
			die("no memory for the boundary");
		return;
	}
	if (!four_numbers(arg, vertex))
		read_numbers(arg, vertex);
	e = corners_given(d, vertex, corner, &at);
	if (e == CORNERS_EINNER)
		die("corner %d is not a vertex of the boundary", at);
	if (e)
		die("corners %d,%d,%d,%d do not go round the boundary once counterclockwise",
		    vertex[0], vertex[1], vertex[2], vertex[3]);
}
