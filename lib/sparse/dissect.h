/* dissect.h - nested dissection of a rectangle of nodes whose neighbours are the eight
 * around each: the fill-reducing order of its sparse systems, without a graph. */
#ifndef DISSECT_H
#define DISSECT_H

/* order[0 .. nu*nv*fields-1]: unknowns (j*nu + i)*fields + f in the order in which to
 * eliminate them.  A line of nodes across the longer side comes after the two halves it
 * parts. */
void dissect(int nu, int nv, int fields, int *order);

#endif
