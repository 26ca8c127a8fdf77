/* chol.h - sparse Cholesky, for a series of systems whose matrices share one graph and one order
 * of elimination.
 *
 * For a torus patch of 1 M vertices, in the order of order.h, the factor has 49 M entries and takes
 * 19e9 floating-point operations; with explicit zeros and padding 66 M numbers are stored. */
#ifndef CHOL_H
#define CHOL_H

#include <stddef.h>

#include "order.h"

enum {
	CHOL_ENOMEM = -1,
	CHOL_EINDEFINITE = -2
};

/* The structure of the factor, which depends on the graph and the order only, and memory for its
 * numbers.  Columns are in postorder.  Neighbouring columns with nearly the same rows form a node
 * (a supernode).  Node s has the columns first[s] .. first[s+1]-1, and below them the rows
 * row[below[s]] .. row[below[s+1]-1], in ascending order. */
typedef struct Chol {
	const Graph *g;
	int     n, nodes;
	int    *order, *place;  /* [n] vertex of a column, column of a vertex */
	int    *first;          /* [nodes+1] */
	int    *parent;         /* [nodes] node of the first row below, -1 if none */
	size_t *below;          /* [nodes+1] */
	int    *row;
	size_t *at;             /* [nodes+1] where the panel (front.h) of a node begins in value */
	double *value;
} Chol;

/* order   in   [g->n] a fill-reducing order, order[0] eliminated first
 *
 * g must live as long as c.  Returns 0 or CHOL_ENOMEM; c must be freed in both cases.
 * chol_bytes(c) is the size of the factor in bytes.  It is known even if memory for the factor ran
 * out; it is 0 if chol_init failed before that. */
int  chol_init(Chol *c, const Graph *g, const int *order);
void chol_free(Chol *c);

double chol_bytes(const Chol *c);

/* A symmetric matrix on the graph.  diagonal[i] is the entry of vertex i on the diagonal, off[k]
 * the entry of the edge to the neighbour g->adj[k]; both directions of an edge have the same entry.
 * Where held[i] is not 0, the row and the column of vertex i are those of the identity.  held may
 * be NULL. */
typedef struct CholMatrix {
	const double *diagonal, *off;
	const unsigned char *held;
} CholMatrix;

/* Solves A x = b; x holds b on entry.  The result has the same bits for any number of threads.
 * Returns 0; CHOL_ENOMEM; or CHOL_EINDEFINITE if A is not positive definite.  In that case *at is
 * the first vertex, in the order of elimination, whose pivot is not positive. */
int  chol_solve(Chol *c, const CholMatrix *a, double *x, int *at);

/* Solves A x = b once more with the matrix of the last chol_solve, which returned 0.  Returns 0 or CHOL_ENOMEM. */
int  chol_again(Chol *c, double *x);

#endif
