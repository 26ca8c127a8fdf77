/* relax.h - turns triangles back by convex combinations (doc/mathematics.md 3.5). */
#ifndef RELAX_H
#define RELAX_H

#include "tangle.h"

/* Moves vertices until no triangle is bad, or nothing helps: each to a mean of its neighbours, with
 * positive weights w.  Where no triangle round a vertex is bad at the places x that are to be kept,
 * the weights are those for which x is the mean.  So with p = x + e
 *
 *   sum_j w_ij (e_j - e_i) + force_i = 0,   force_i = sum_j w_ij (x_j - x_i),
 *
 * where the force is 0 except near bad triangles.  Only their neighbourhood moves.  It grows while it
 * is too small, in the end to the whole disk, where a theorem says that no triangle is turned over. */
void relax(Tangle *t);

/* Then moves the vertices back to their places, or as near as no triangle becomes bad. */
void relax_back(Tangle *t);

#endif
