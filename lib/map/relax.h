/* relax.h - turns triangles back by convex combinations (doc/mathematics.md 3.5). */
#ifndef RELAX_H
#define RELAX_H

#include "tangle.h"

/* Moves vertices until no triangle is bad, or the limits of sweeps are reached: each to a mean of its
 * neighbours, with positive weights w.  Where no triangle at vertex i is bad at the given places x, the
 * weights are those for which x_i is the mean.  So with p = x + e
 *
 *   sum_j w_ij (e_j - e_i) + force_i = 0,   force_i = sum_j w_ij (x_j - x_i),
 *
 * where the force is 0 except near bad triangles.  Only a region around these moves.  The region grows
 * until no triangle is bad, at most to the whole disk; for that the solution has no triangle turned
 * over (Tutte, Floater). */
void relax(Tangle *t);

/* Then moves the vertices back to their given places, or as near to these as leaves no further
 * triangle bad. */
void relax_back(Tangle *t);

#endif
