/* cg.h - preconditioned conjugate gradients in a trust region (T. Steihaug 1983).
 *
 * Minimises  <x, A x>/2 - <b, x>  for symmetric positive definite A and preconditioner P. */
#ifndef CG_H
#define CG_H

#include <stddef.h>

typedef struct CgSystem {
	size_t n;               /* unknowns */
	void (*apply)(void *ctx, const double *p, double *q);           /* q = A p */
	void (*precondition)(void *ctx, const double *r, double *z);    /* z = P^-1 r */
	void  *ctx;
} CgSystem;

typedef struct CgLimits {
	double reduction;       /* stop at this share of the first |r|, in the norm of P^-1 */
	int    steps;
	double radius;          /* bounds |x - start| in the norm of P; HUGE_VAL: no bound */
	double worth;           /* stop when a step adds less than this times the decrease so far */
	double before;          /* decrease before this call: added to the decrease so far in the test
	                         * with worth, but not in the result */
} CgLimits;

typedef struct CgResult {
	double decrease;        /* twice the decrease of the function */
	double length;          /* |x - start| in the norm of P, at most the radius */
	int    steps;           /* without the last one if it was stopped by radius or worth */
} CgResult;

/* x  in/out  in: the start; out: the solution
 * r  in/out  in: the residual b - A x of the start; out: overwritten, perhaps not updated after the
 *            last step
 * z, p, q    workspace of n numbers each */
CgResult cg(const CgSystem *s, const CgLimits *limits, double *x, double *r, double *z, double *p,
	double *q);

#endif
