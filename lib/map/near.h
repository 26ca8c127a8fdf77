/* near.h - a disk moved near the origin and numbered anew, for maps that depend on neither.
 *
 * Points are added on edges; far from the origin, rounding of their coordinates would bend the
 * surface.  So the surface is mapped near the origin.  Ties are broken in favour of lower numbers, and
 * sums are rounded in the order of the numbers.  So the vertices and faces are first renumbered in a
 * way that does not depend on their numbers.
 */
#ifndef NEAR_H
#define NEAR_H

#include "../mesh/traversal.h"

enum { NEAR_ENOMEM = -1 };

typedef struct Near {
	Traversal t;            /* t.d is the disk moved by -offset, numbered from one of its corners on */
	int       corner[4];    /* in the loop of t.d */
	double    offset[3];
} Near;

/* corner: in the loop of d.  Returns 0, or NEAR_ENOMEM with nothing to free. */
int  near_init(Near *n, const Disk *d, const int corner[4]);
void near_free(Near *n);

/* Puts x, malloc'd, given at the vertices of n, in the order of the vertices of the given disk.  Returns 0 or
 * NEAR_ENOMEM. */
int  near_restore(const Near *n, double **x);

/* Fields f, [fields][nv] at the vertices of the given disk, in the order of n: pointers and numbers in one piece,
 * to be freed; NULL if memory runs out. */
double **near_fields(const Near *n, int fields, const double *const *f);

/* The vertex of the given disk that has that number in n, -1 if it was added. */
int  near_given(const Near *n, int number);

#endif
