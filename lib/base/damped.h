/* damped.h - the least value of a function of few variables, by damped Newton steps.
 *
 * K. Levenberg, Quarterly of Applied Mathematics 2 (1944) 164; D. W. Marquardt, SIAM Journal 11 (1963) 431.
 */
#ifndef DAMPED_H
#define DAMPED_H

enum { DAMPED_MOST = 8 };       /* variables */

/* A function f on a set of points, which are changed by n numbers; 0 is no change. */
typedef struct DampedProblem {
	int    n;                       /* 1 .. DAMPED_MOST */
	void  *ctx;
	double (*value)(void *ctx, const double *change);       /* f at the changed point; may be infinite */
	void   (*move)(void *ctx, const double *change);        /* the changed point becomes the point */
	double (*derivatives)(void *ctx, double *g, double (*H)[DAMPED_MOST]);  /* f at the point, its gradient,
	                                 * and a positive semidefinite approximation of its Hessian */
	int    steps;                   /* most steps that are taken */
	double near;                    /* ends when a step lowers f by at most this */
} DampedProblem;

/* Moves the point to lower values of f, and returns f there.  Each step solves (H + t diag H) x = -g; t is raised
 * until f falls. */
double damped_newton(const DampedProblem *p);

#endif
