/* chol.h - sparse Cholesky: systems that share the graph of their matrix and the order of
 * elimination, solved one after the other.
 *
 * A torus patch of 1 M vertices in the order of order.h has 50 M entries, 21 gigaflops;
 * kept are 66 M numbers. */
#ifndef CHOL_H
#define CHOL_H

#include <stddef.h>

#include "order.h"

enum {
	CHOL_ENOMEM = -1,
	CHOL_EINDEFINITE = -2
};

/* What the graph and the order decide.  Columns are those of the factor, postordered;
 * neighbouring ones of about the same rows are kept together, as nodes.  Node s has
 * columns first[s] .. first[s+1]-1 and the rows row[below[s]] .. row[below[s+1]-1], rising,
 * below them. */
typedef struct Chol {
	const Graph *g;
	int     n, nodes;
	int    *order, *place;  /* [n] vertex at a column, column of a vertex */
	int    *first;          /* [nodes+1] */
	int    *parent;         /* [nodes] the node of the first row below, -1 if there is none */
	size_t *below;          /* [nodes+1] */
	int    *row;
	size_t *at;             /* [nodes+1] the node's panel in value */
	double *value;
} Chol;

/* order   in   [g->n] a fill-reducing order, order[0] eliminated first
 *
 * g must live as long as c.  Returns 0 or CHOL_ENOMEM; c is to be freed in both
 * cases, and chol_bytes(c) says what the factor takes, 0 if that is not known yet. */
int  chol_init(Chol *c, const Graph *g, const int *order);
void chol_free(Chol *c);

double chol_bytes(const Chol *c);

/* A matrix on the graph: diagonal[i] and off[k] for the neighbour g->adj[k], the same
 * at both ends of an edge.  Where held[i] is not 0, the row and the column of vertex i are
 * those of the identity; held may be NULL. */
typedef struct CholMatrix {
	const double *diagonal, *off;
	const unsigned char *held;
} CholMatrix;

/* Solve A x = b; b is in x.  Any number of threads, the same bits.  Returns 0,
 * CHOL_ENOMEM, or CHOL_EINDEFINITE: A is not positive definite, *at is the first vertex
 * in the order of elimination to show it. */
int  chol_solve(Chol *c, const CholMatrix *a, double *x, int *at);

#endif
