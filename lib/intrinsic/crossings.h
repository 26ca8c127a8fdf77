/* crossings.h - where the edges of the mesh cross those of an intrinsic triangulation.
 *
 * Every edge of the mesh that is not an edge of the triangulation crosses some of its edges.
 * Which ones, and in which order, is kept as integers: a flip changes them without any
 * geometry.  Within a triangle the pieces of mesh edges cannot cross each other; so the
 * numbers of crossings on its three sides determine where each piece goes.
 */
#ifndef CROSSINGS_H
#define CROSSINGS_H

#include "intrinsic.h"

/* Updates the lists for the flip of the edge of side h; to be called before the flip.  Returns 0 or
 * INTRINSIC_ENOMEM. */
int crossings_flip(Intrinsic *t, int h);

/* The pieces of mesh edges within a triangle.  A piece goes round a corner, from one side to the
 * next; or it starts at a corner and goes to the opposite side, which is possible at one corner
 * only. */
typedef struct Pieces {
	int round[3];           /* number of pieces round each corner */
	int start[3];           /* number of pieces that start at each corner; > 0 at one at most */
} Pieces;

Pieces crossings_pieces(const Intrinsic *t, int triangle);

/* The number of crossings of side h. */
int crossings_on(const Intrinsic *t, int h);

/* The mesh edge at crossing p of side h, counted from the start of the side. */
int crossings_mesh_edge(const Intrinsic *t, int h, int p);

/* Crossing number `at` of a side, counted from the start of the side; a corner if at < 0. */
typedef struct Crossing {
	int side, at;
} Crossing;

/* Where the mesh edge that enters a triangle at crossing p of its side h leaves it.  at = -1: it
 * ends at the opposite corner. */
Crossing crossings_follow(const Intrinsic *t, int h, int p);

/* The same crossing seen from the other triangle. */
Crossing crossings_across(const Intrinsic *t, Crossing a);

#endif
