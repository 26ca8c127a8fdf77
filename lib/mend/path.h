/* path.h - shortest paths along the edges of a sheet.  Private to lib/mend. */
#ifndef PATH_H
#define PATH_H

#include "sheet.h"

/* Shortest paths from one vertex (Dijkstra).  via[v] is the side at the end of the path to v: from the
 * vertex before v to v, or from v to it; -1 at the start and where no path leads.  order[0..n-1] are
 * the vertices reached, nearest first. */
typedef struct PathTree {
	int    *first, *corner; /* the corners at each vertex */
	int    *via, *order, n;
	double *distance;       /* HUGE_VAL where no path leads */
	struct PathItem *heap;
	int     count;
} PathTree;

/* Returns 0 or MESH_ENOMEM, with nothing to free. */
int  path_init(PathTree *t, const Sheet *s);
void path_free(PathTree *t);

/* Finds the paths from vertex v through the vertices w with barred[w] == 0; barred may be NULL. */
void path_from(PathTree *t, const Sheet *s, int v, const unsigned char *barred);

/* The vertex before v on its path; v is not the start. */
int path_before(const PathTree *t, const Sheet *s, int v);

/* Cuts the surface along a side: its two faces are no longer neighbours. */
void path_cut(Sheet *s, int side);

#endif
