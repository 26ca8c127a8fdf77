/* intrinsicmatrix.h - linear and quadratic elements on an intrinsic triangulation. */
#ifndef INTRINSICMATRIX_H
#define INTRINSICMATRIX_H

#include "../intrinsic/intrinsic.h"
#include "../sparse/order.h"

/* A symmetric matrix whose rows sum to 0, without its diagonal, as harmonic.h has it. */
typedef struct IntrinsicMatrix {
	Graph   g;
	double *off;
} IntrinsicMatrix;

/* The unknowns of quadratic elements: values at the vertices and, after them, at the middles of the
 * edges. At the middle of a straight edge the value is the mean of its ends, and there is no
 * unknown. */
typedef struct Middles {
	int *unknown;           /* [ne] of each edge, or -1: straight */
	int  n;                 /* of all unknowns */
} Middles;

/* The matrix of linear elements; a weight below 1e-10 is replaced by it.  Returns 0 or
 * INTRINSIC_ENOMEM; a then holds nothing to free. */
int  intrinsic_linear(const Intrinsic *t, IntrinsicMatrix *a);

/* The matrix of quadratic elements, (4 C_fine - C_coarse)/3 as in cotangent.h.  Returns 0 or
 * INTRINSIC_ENOMEM; a then holds nothing to free. */
int  intrinsic_quadratic(const Intrinsic *t, const Middles *m, IntrinsicMatrix *a);
void intrinsic_matrix_free(IntrinsicMatrix *a);

/* Numbers the unknowns.  straight: [ne], 1 for a straight edge. */
void intrinsic_middles(const Intrinsic *t, const unsigned char *straight, Middles *m);

/* Continues side, of the vertices (harmonic_sides), to all unknowns. */
void intrinsic_middle_sides(const Intrinsic *t, const Middles *m, unsigned char *side);

/* From the unknowns to the values at the vertices and all middles; x: [nv + ne]. */
void intrinsic_middle_values(const Intrinsic *t, const Middles *m, double *x);

/* The Dirichlet energy of linear elements, with the true weights.  x: [nv] */
double intrinsic_energy(const Intrinsic *t, const double *x);

/* The energy of quadratic elements.  x: [nv + ne] */
double intrinsic_quadratic_energy(const Intrinsic *t, const double *x);

#endif
