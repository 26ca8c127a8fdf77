/* simplex.h - the downhill simplex of J. A. Nelder and R. Mead (The Computer Journal 7 (1965) 308). */
#ifndef SIMPLEX_H
#define SIMPLEX_H

enum { SIMPLEX_MOST = 8 };      /* variables */

typedef struct SimplexProblem {
	int    n;                       /* variables, 1 .. SIMPLEX_MOST */
	double (*f)(void *ctx, const double *x);        /* may be infinite */
	void  *ctx;
	double reach;                   /* the first simplex: 0, and this far along each axis */
	int    steps;                   /* most steps, of one or two values each; n more if the simplex shrinks */
	double near;                    /* ends when the values at the corners differ by at most this */
} SimplexProblem;

/* Sets x[n] to the best corner of the last simplex, and returns f there. */
double simplex(const SimplexProblem *p, double *x);

#endif
