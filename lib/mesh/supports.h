/* supports.h - where the vertices of a subdivision lie in the given disk, and the steps between them. */
#ifndef SUPPORTS_H
#define SUPPORTS_H

#include "subdivision.h"

/* The vertex, edge or face of the given disk on which a vertex of the subdivision lies, as one, two
 * or three vertices of the given disk, and its barycentric coordinates there, all positive.  Unused
 * vertices are -1, their coordinates 0. */
typedef struct Support {
	int    v[3];
	double w[3];
} Support;

/* The supports of the vertices of s, [s->d.m.nv], to be freed; NULL if memory runs out. */
Support *supports(const Subdivision *s);

/* Adds to a the vertices of b that it does not have, as long as there is room. */
void     support_join(Support *a, const Support *b);

/* The step in R^3 from vertex i to vertex j, which lie in one face of the given disk.  Near a vertex
 * of the given disk its relative error is that of its coordinates.  (The difference of the positions
 * would have the rounding errors of the positions: steps of 1e-9 of their size would lose nine
 * digits.) */
void     support_step(const Subdivision *s, const Support *support, int i, int j, double step[3]);

#endif
