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

/* Computes the diagonal from off, so that rows sum to 0, and solves for u and v1: u is 0 on the left
 * and 1 on the right side, v1 is 0 on the bottom and 1 on the top, and A u = 0, A v1 = 0 at all other
 * vertices.
 *
 * u, v1   out  [n]
 * report  out  on SPD_EINDEFINITE, column is the vertex at which the factorization failed
 *
 * Returns 0, SPD_ENOMEM or SPD_EINDEFINITE. */
int harmonic_pair(Harmonic *h, double *u, double *v1, SpdReport *report);

/* T and the certificate from the energies of u and v1 (doc/mathematics.md 3.2).
 *
 * v  in/out  [n] v1; v = T v1
 *
 * Returns 0, or SPD_EINDEFINITE if the energies are not positive. */
int harmonic_modulus(double Eu, double Ev, int n, double *v, double *T, double *certificate);

#endif
