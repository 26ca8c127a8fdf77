/* crossings.h - which edges of the mesh cross the edges of an intrinsic triangulation.
 *
 * An edge of the mesh that is not an edge of the triangulation crosses edges of the triangulation.
 * For each edge of the triangulation the mesh edges that cross it are recorded in order, as
 * integers, and a flip updates these lists without computing with lengths.  Mesh edges do not cross
 * each other, so within a triangle the numbers of crossings on its three sides determine where each
 * piece goes.
 */
#ifndef CROSSINGS_H
#define CROSSINGS_H

#include "intrinsic.h"

/* Updates the lists for the flip of the edge of side h.  Call it before the flip.  Returns 0 or
 * INTRINSIC_ENOMEM. */
int crossings_flip(Intrinsic *t, int h);

/* The pieces of mesh edges within a triangle.  A piece either cuts off a corner, from one side to a
 * neighbouring one; or it starts at a corner and ends on the opposite side.  The second kind occurs
 * at one corner of a triangle at most, because pieces do not cross. */
typedef struct Pieces {
	int round[3];           /* number of pieces that cut off each corner */
	int start[3];           /* number of pieces that start at each corner */
} Pieces;

Pieces crossings_pieces(const Intrinsic *t, int triangle);

/* The number of crossings of side h. */
int crossings_on(const Intrinsic *t, int h);

/* The mesh edge at crossing p of side h, counted from the start of the side. */
int crossings_mesh_edge(const Intrinsic *t, int h, int p);

/* Crossing number `at` (0, 1, ..) of a side, counted from the start of the side.  at < 0: no
 * crossing, but a corner. */
typedef struct Crossing {
	int side, at;
} Crossing;

/* A mesh edge enters a triangle at crossing p of its side h.  Returns the crossing by which it
 * leaves the triangle; at = -1 if it ends at the corner opposite to h instead. */
Crossing crossings_follow(const Intrinsic *t, int h, int p);

/* The same crossing, given on the twin of its side. */
Crossing crossings_across(const Intrinsic *t, Crossing a);

#endif
