/* lbfgs.h - the limited-memory BFGS method: a minimum of a function of many variables
 * (J. Nocedal, "Updating quasi-Newton matrices with limited storage", Math. Comp. 35, 1980).
 */
#ifndef LBFGS_H
#define LBFGS_H

enum { LBFGS_ENOMEM = -1 };

typedef struct Lbfgs {
	int    steps;           /* at most so many */
	double shorter;         /* the first step changes no variable by more */
	double tol;             /* ends when a step lowers the function by less than this share of it */
	const double *prec;     /* [n] > 0: diagonal approximation of the inverse Hessian */
} Lbfgs;

/* The value at x, and the gradient in g; or INFINITY where the function is not defined, g is then
 * not used. */
typedef double LbfgsValue(void *ctx, const double *x, double *g);

/* Lowers f from x, where it must be finite; x is replaced by the lowest point found, *value by the
 * value there.  Step lengths are halved until the decrease is 1e-4 of the predicted one.
 * Returns 0 or LBFGS_ENOMEM. */
int lbfgs(const Lbfgs *o, int n, LbfgsValue *f, void *ctx, double *x, double *value);

#endif
