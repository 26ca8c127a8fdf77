/* corneropt.c - the option --corners of mesh2rect. */
#include <stdlib.h>
#include <string.h>

#include "../../lib/map/corners.h"
#include "../shared/cmd.h"
#include "corneropt.h"
#include "vertexlist.h"

static void
read_file(const char *path, VertexList *g)
{
	size_t n;
	char *bytes = cmd_slurp(path, &n), *s = cmd_alloc(n + 1, 1);

	memcpy(s, bytes, n);
	s[n] = '\0';
	if (strlen(s) != n || !vertexlist(s, 4, g))
		die("%s: not four vertex numbers and not four points x,y,z", path);
	free(bytes);
	free(s);
}

static void
set_corners(const VertexList *g, const Disk *d, int corner[4])
{
	int v[4], at, k, e;

	for (k = 0; k < 4; k++)
		v[k] = g->n == 4 ? vertexlist_number(d, "corner", "the boundary", g->x[k]) : corners_nearest(d, g->x + 3*k);
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
	VertexList g;

	if (!arg || strcmp(arg, "auto") == 0) {
		if (corners_auto(d, corner) < 0)
			die("no memory for the boundary");
		return;
	}
	if (!vertexlist(arg, 4, &g)) {
		if (strpbrk(arg, VERTEXLIST_MARKS) && strspn(arg, "0123456789.+-eE,; \t\r\n") == strlen(arg))
			misuse("--corners=%s: need four vertex numbers or four points x,y,z;..", arg);
		read_file(arg, &g);
	}
	set_corners(&g, d, corner);
}
