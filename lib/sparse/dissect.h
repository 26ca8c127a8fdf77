/* dissect.h - nested dissection of a rectangular grid: a fill-reducing order for sparse systems
 * that couple each node to the eight around it.  No graph is needed. */
#ifndef DISSECT_H
#define DISSECT_H

/* Sets order[0 .. nu*nv*fields-1] to the unknowns (j*nu + i)*fields + f in the order in which they
 * are to be eliminated.  A line of nodes across the longer side comes after the two halves that it
 * separates. */
void dissect(int nu, int nv, int fields, int *order);

#endif
