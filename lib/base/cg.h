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
	double reduction;       /* stop when |r| in the norm of P^-1 is this share of its first value */
	int    steps;
	double radius;          /* of the trust region: |x - start| in the norm of P; or HUGE_VAL */
	double worth;           /* stop when a step adds less than this share of the decrease so far */
	double before;          /* decrease that led to the start; worth counts it, the result does not */
} CgLimits;

typedef struct CgResult {
	double decrease;        /* twice the decrease of the function */
	double length;          /* |x - start| in the norm of P, the radius if that was reached */
	int    steps;           /* equal to the limit if nothing else stopped it before */
} CgResult;

/* x  in/out  in: the start; out: the solution
 * r  in/out  in: the residual b - A x of the start; out: the residual before or after the last step
 * z, p, q    workspace of n numbers each */
CgResult cg(const CgSystem *s, const CgLimits *limits, double *x, double *r, double *z, double *p,
	double *q);

#endif
