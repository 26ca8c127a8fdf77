/* longestside.h - the sides that longest-edge bisection cuts (Rivara). */
#ifndef LONGESTSIDE_H
#define LONGESTSIDE_H

#include <limits.h>

#include "mesh.h"

/* Returns the longest side of face f.  Side 3*f + k runs from corner k to the next.  Of sides that
 * are equally long up to rounding, the one is returned whose ends have the largest sum of keys.  If
 * the sums are equal, too, or key is NULL, it is the side of the edge with the lowest number.  The
 * number of an edge is the lower of its two sides, so both faces at an edge choose by the same rule.
 *
 * key  in  [nv] numbers that do not depend on how the vertices are numbered, or NULL */
int longest_side(const Disk *d, const double *key, int f);

enum { SIDE_CUT = INT_MAX };

/* Finds the sides to cut: all sides of the marked faces, and, until nothing changes, the longest
 * side of each face that has a cut side.
 *
 * marked  in   [nf]; NULL: all
 * cut     out  [3*nf] SIDE_CUT, or -1; the same for both sides of an edge
 *
 * Returns 0 or MESH_ENOMEM. */
int cut_sides(const Disk *d, const unsigned char *marked, const double *key, int *cut);

#endif
