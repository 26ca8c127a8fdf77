/* clean.h - from the polygons of a file to triangles that can be repaired.  Private to lib/mend. */
#ifndef CLEAN_H
#define CLEAN_H

#include "sheet.h"

/* Counts of what was left out; and, as x_at, the first of each kind, numbered as in the file, or -1. */
typedef struct Cleaned {
	int unused;             /* vertices of no face */
	int missing, missing_at;        /* faces with a corner that is no vertex; the first */
	int infinite, infinite_at;      /* faces at a vertex that is not finite; that vertex */
	int broken, broken_at;  /* faces of fewer than three different corners, or with one twice */
	int twice, twice_at;    /* faces on the same three places as one before them */
} Cleaned;

/* Splits the polygons of a soup into triangles: sets s, without twins, all vertices with their numbers
 * in the soup.  Triangles keep their corners; equal corners in a row count once; a polygon that cannot
 * be split into triangles with area is split into a fan.  The faces counted in c are left out.  Faces
 * marked as filled in the soup stay marked.
 *
 * Returns 0, MESH_ENOMEM, or MESH_EDISK if no face is left. */
int sheet_clean(Sheet *s, const Soup *soup, Cleaned *c);

#endif
