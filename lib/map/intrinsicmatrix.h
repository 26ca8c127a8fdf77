/* intrinsicmatrix.h - linear and quadratic elements on an intrinsic triangulation. */
#ifndef INTRINSICMATRIX_H
#define INTRINSICMATRIX_H

#include "../intrinsic/intrinsic.h"
#include "../sparse/order.h"

/* A symmetric matrix whose rows sum to 0, without its diagonal: g and off of Harmonic
 * (harmonic.h). */
typedef struct IntrinsicMatrix {
	Graph   g;
	double *off;
} IntrinsicMatrix;

/* The unknowns of quadratic elements: values at the vertices and, after them, at the midpoints of
 * the edges.  An edge may be declared straight: the value at its midpoint is then the mean of those
 * at its ends, and not an unknown. */
typedef struct Middles {
	int *unknown;           /* [ne] the unknown at each edge, -1 if it is straight */
	int  n;                 /* number of unknowns, those at vertices included */
} Middles;

/* The matrix of linear elements; weights below 1e-10 are replaced by 1e-10.  Returns 0 or
 * INTRINSIC_ENOMEM; a then holds nothing to free. */
int  intrinsic_linear(const Intrinsic *t, IntrinsicMatrix *a);

/* The matrix of quadratic elements, (4 C_fine - C_coarse)/3 as in cotangent.h.  Returns 0 or
 * INTRINSIC_ENOMEM; a then holds nothing to free. */
int  intrinsic_quadratic(const Intrinsic *t, const Middles *m, IntrinsicMatrix *a);
void intrinsic_matrix_free(IntrinsicMatrix *a);

/* Numbers the unknowns.  straight: [ne], 1 for a straight edge; m->unknown must have room for
 * ne. */
void intrinsic_middles(const Intrinsic *t, const unsigned char *straight, Middles *m);

/* side: [m->n], in: the sides of the vertices (harmonic_sides); out: those of all unknowns. */
void intrinsic_middle_sides(const Intrinsic *t, const Middles *m, unsigned char *side);

/* x: [nv + ne], in: the values of the unknowns; out: at the vertices and the midpoints of all
 * edges. */
void intrinsic_middle_values(const Intrinsic *t, const Middles *m, double *x);

/* The Dirichlet energy of linear elements; small weights are not replaced.  x: [nv] */
double intrinsic_energy(const Intrinsic *t, const double *x);

/* The Dirichlet energy of quadratic elements.  x: [nv + ne] */
double intrinsic_quadratic_energy(const Intrinsic *t, const double *x);

#endif
