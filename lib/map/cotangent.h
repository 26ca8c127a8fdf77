/* cotangent.h - the cotangent matrix C of a mesh: C_ij = -(cot a + cot b)/2 over the two
 * angles that face edge ij, rows summing to 0; <x, C x> is the Dirichlet energy of x. */
#ifndef COTANGENT_H
#define COTANGENT_H

#include "../mesh/mesh.h"
#include "../sparse/order.h"

enum { COTANGENT_ENOMEM = -1 };

/* C of a disk off its diagonal: c[k] = C_ij for neighbour j = g.adj[k] of vertex i. */
typedef struct Cotangent {
	Graph   g;
	double *c;
	int    *place;          /* [3*nf] in c, of the side that faces each corner; until c is known */
} Cotangent;

/* Returns 0 or COTANGENT_ENOMEM, nothing to free then. */
int  cotangent_init(Cotangent *C, const Disk *d);
void cotangent_free(Cotangent *C);

/* The same in two steps: the graph, which is all that is needed for an order, and c. */
int  cotangent_graph(Cotangent *C, const Disk *d);
void cotangent_values(Cotangent *C, const Disk *d);

/* The stiffness matrix of quadratic elements on a mesh, whose unknowns are the values at its
 * vertices and, after them, at the midpoints of its edges: with every triangle split
 * into four at the midpoints it is (4 C_fine - C_coarse)/3, C_coarse being 0 at the
 * midpoints.  fine becomes it.  Returns 0 or COTANGENT_ENOMEM; fine is then what it was. */
int cotangent_quadratic(Cotangent *fine, const Cotangent *coarse);

/* y = C x. */
void cotangent_apply(const Mesh *m, const double *x, double *y);

/* <u, C u> and <v, C v>, summed over triangles.  Returns 0 or COTANGENT_ENOMEM. */
int cotangent_energy(const Mesh *m, const double *u, const double *v, double *Eu, double *Ev);

#endif
