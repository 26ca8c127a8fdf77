/* harmonic.h - discrete harmonic functions of a disk with given values on two of its four sides. */
#ifndef HARMONIC_H
#define HARMONIC_H

#include "../mesh/mesh.h"
#include "../sparse/chol.h"
#include "../sparse/spd.h"

/* The sides of the quadrilateral, as bits; a corner belongs to two sides. */
enum { SIDE_BOTTOM = 1, SIDE_RIGHT = 2, SIDE_TOP = 4, SIDE_LEFT = 8 };

/* Sets side to the sides that each vertex lies on, 0 for an inner vertex.
 *
 * corner  in   indices into the boundary loop (corners.h)
 * side    out  [d->m.nv] */
void harmonic_sides(const Disk *d, const int corner[4], unsigned char *side);

/* A symmetric matrix A whose rows sum to 0, and its factor. */
typedef struct Harmonic {
	const Graph         *g;
	const double        *off;       /* the off-diagonal entries, in the order of CholMatrix */
	double              *diagonal;  /* [g->n] */
	Chol                 chol;      /* of g */
	const unsigned char *side;      /* [g->n] of harmonic_sides */
} Harmonic;

/* Solves for x: it is 0 on the sides `zero`, 1 on the sides `one` (bits), and A x = 0 at all other
 * vertices.
 *
 * x       out  [n]
 * report  out  on SPD_EINDEFINITE, column is the vertex at which the factorization failed
 *
 * Returns 0, SPD_ENOMEM or SPD_EINDEFINITE. */
int harmonic_solve(Harmonic *h, int zero, int one, double *x, SpdReport *report);

/* Computes the diagonal from off, so that rows sum to 0. */
void harmonic_diagonal(Harmonic *h);

#endif
