/* longestside.h - the sides that longest-edge bisection cuts (Rivara). */
#ifndef LONGESTSIDE_H
#define LONGESTSIDE_H

#include <limits.h>

#include "mesh.h"

/* The longest side of face f.  Of sides that are equally long up to rounding, it is the one whose
 * ends have the largest sum of keys; if these are equal, too, or key is NULL, the one whose
 * edge contains the side of lowest number.  So both faces at an edge choose by the same rule.  Side
 * 3*f + k runs from corner k to the next.
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
