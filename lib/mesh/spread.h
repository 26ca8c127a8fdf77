/* spread.h - numbers for vertices that have none, from their neighbours. */
#ifndef SPREAD_H
#define SPREAD_H

#include "mesh.h"

/* The vertices without numbers that faces join to others, from these inwards: first those next to one with numbers, then
 * those next to them, .. */
typedef struct Spread {
	int  n;
	int *vertex;            /* [n] */
	int *first, *near;      /* the neighbours of vertex[i] that come before it, or have numbers:
	                         * near[first[i]] .. near[first[i+1]-1], one for each face that both are corners of */
	int *nearest;           /* [n] the vertex with numbers to which the way along these neighbours is shortest */
} Spread;

/* known is [s->nv]: 1 where a vertex has numbers.  Corners of s that are no vertex are skipped.  Returns 0, or MESH_ENOMEM
 * with nothing to free. */
int spread_init(Spread *a, const Soup *s, const unsigned char *known);
void spread_free(Spread *a);

/* Sets f, n numbers at each vertex, where it has none: to the mean of these neighbours, of which those that are not
 * finite are left out, nan if all are. */
void spread_mean(const Spread *a, int n, double *f);

/* The same: to the numbers of the nearest vertex that has some. */
void spread_nearest(const Spread *a, int n, double *f);

#endif
