/* hole.h - fills the holes of a sheet.  Private to lib/mend. */
#ifndef HOLE_H
#define HOLE_H

#include "loop.h"
#include "sheet.h"

typedef struct Filled {
	int    seams;           /* loops closed by splitting an edge at the vertices that lie on it */
	int    holes;           /* loops filled */
	double longest;         /* of the loops filled */
	int    faces, vertices; /* made */
	int    left, left_at;   /* loops that could not be triangulated, a vertex of the first or -1 */
	int    order;           /* FAIR_ value that was used */
} Filled;

/* Closes each loop whose vertices all lie on its longest edge, within a millionth of it: the edge is
 * split there.  Returns the number of loops closed, or MESH_ENOMEM. */
int hole_seams(Sheet *s);

/* Fills n loops and fairs the patches.  New vertices and faces follow the others, with source -1 and
 * filled 1.  Adds to *r.  Returns 0, MESH_ENOMEM, or MESH_EDISK if CGAL fails. */
int hole_fill(Sheet *s, const Loop *loop, int n, int order, Filled *r);

#endif
