/* polypriv.h - a polygon that is being split.  Private to polygon.c, polyshape.c
 * and earclip.c. */
#ifndef POLYPRIV_H
#define POLYPRIV_H

#include <stddef.h>

#define POLYGON_FLAT 1e-14      /* a smaller ratio of area to longest edge squared counts as 0 */
#define POLYGON_TINY 1e-150     /* squares of lengths between this and its inverse are well
                                 * within the range of a double */

typedef struct Polygon {
	const double *xyz;
	int    n;
	const int *v;           /* its corners */
	double (*flat)[2];      /* clipping: corners in the average plane */
	int   *next, *prev;     /* clipping: the ring of the remaining corners */
	int   *tri;             /* where the next triangle goes */
} Polygon;

/* Edges from a to b and to c, scaled so that the largest component is 1.  Returns 0 if they are too
 * short or too long to measure (POLYGON_TINY). */
int polygon_edges(const double *a, const double *b, const double *c, double u[3], double v[3]);

/* Shape of the triangle a b c: area over the longest edge squared, at most 0.433, as a vector along
 * its normal; 0 if it is too small or too large to measure. */
void polygon_shape(const double *a, const double *b, const double *c, double n[3]);

/* Splits p by clipping ears.  Returns 1, or 0 if that is impossible. */
int polygon_clip(Polygon *p);

static inline const double *
polygon_at(const Polygon *p, int i)
{
	return p->xyz + 3*(size_t)p->v[i];
}

/* Appends the triangle of corners a, b, c of the polygon. */
static inline void
polygon_put(Polygon *p, int a, int b, int c)
{
	*p->tri++ = p->v[a];
	*p->tri++ = p->v[b];
	*p->tri++ = p->v[c];
}

#endif
