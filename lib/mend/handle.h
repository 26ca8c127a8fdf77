/* handle.h - handles are cut along short cycles, and closed.  Private to lib/mend. */
#ifndef HANDLE_H
#define HANDLE_H

#include "hole.h"
#include "sheet.h"

/* Cuts every handle along a cycle of edges that does not separate its component, and fills both sides,
 * faired as `order` says.  Of each base vertex the cycle is the shortest one through it [J. Erickson,
 * K. Whittlesey, Greedy optimal homotopy and homology generators, SODA 2005, 1038-1046]; the base moves
 * along the cycle found while this makes it shorter.
 *
 * cuts   out  the number of cycles
 * length out  of all cycles
 * r      out  what was filled
 *
 * Returns 0, MESH_ENOMEM, or MESH_EDISK if a side of a cut cannot be filled, or a handle cannot be cut
 * without touching the boundary. */
int handle_cut(Sheet *s, int order, int *cuts, double *length, Filled *r);

#endif
