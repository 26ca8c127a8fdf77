/* handle.h - cuts handles along short cycles, and fills the cuts.  Private to lib/mend. */
#ifndef HANDLE_H
#define HANDLE_H

#include "hole.h"
#include "sheet.h"

/* Cuts every handle along a cycle of edges that does not separate its component, and fills both sides,
 * faired as `order` says.  The cycle is the shortest one through a base vertex [J. Erickson,
 * K. Whittlesey, Greedy optimal homotopy and homology generators, SODA 2005, 1038-1046]; the base moves
 * to the far side of its cycle as long as the new cycle is shorter.
 *
 * cuts   out  the number of cycles
 * length out  the length of all cycles together
 * r      out  the holes filled
 *
 * Returns 0, MESH_ENOMEM, or MESH_EDISK if a side of a cut cannot be filled, or a handle cannot be cut
 * without touching the boundary. */
int handle_cut(Sheet *s, int order, int *cuts, double *length, Filled *r);

#endif
