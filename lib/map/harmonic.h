/* harmonic.h - discrete harmonic functions of a disk with given values on two of its four sides. */
#ifndef HARMONIC_H
#define HARMONIC_H

#include "../mesh/mesh.h"
#include "../sparse/chol.h"
#include "../sparse/spd.h"

/* The sides of the quadrilateral, as bits; a corner belongs to two. */
enum { SIDE_BOTTOM = 1, SIDE_RIGHT = 2, SIDE_TOP = 4, SIDE_LEFT = 8 };

/* The sides of each vertex.
 *
 * corner  in   indices into the boundary loop (corners.h)
 * side    out  [d->m.nv] */
void harmonic_sides(const Disk *d, const int corner[4], unsigned char *side);

/* A matrix whose rows sum to 0, and its factor. */
typedef struct Harmonic {
	const Graph         *g;
	const double        *off;       /* the entries off the diagonal, in the order of CholMatrix */
	double              *diagonal;  /* [g->n] */
	Chol                 chol;      /* of g */
	const unsigned char *side;      /* [g->n] */
} Harmonic;

/* The x with A x = 0 at all vertices but those of the sides `zero` and `one`, where it is 0 and 1.
 *
 * x       out  [n]
 * report  out  on SPD_EINDEFINITE the vertex
 *
 * Returns 0, SPD_ENOMEM or SPD_EINDEFINITE. */
int harmonic_solve(Harmonic *h, int zero, int one, double *x, SpdReport *report);

/* Fills diagonal from off. */
void harmonic_diagonal(Harmonic *h);

#endif
