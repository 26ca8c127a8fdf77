/* cotangent.h - the cotangent matrix C of a mesh: C_ij = -(cot a + cot b)/2, where a and b
 * are the angles opposite to edge ij, and the rows sum to 0.  <x, C x> is the Dirichlet energy of
 * x. */
#ifndef COTANGENT_H
#define COTANGENT_H

#include "../mesh/mesh.h"
#include "../sparse/order.h"

enum { COTANGENT_ENOMEM = -1 };

/* The off-diagonal entries of C of a disk: c[k] = C_ij for neighbour j = g.adj[k] of vertex i. */
typedef struct Cotangent {
	Graph   g;
	double *c;
	int    *place;          /* [3*nf] index in c of the side opposite to each corner; NULL
	                         * once c is known */
} Cotangent;

/* Returns 0 or COTANGENT_ENOMEM; C then holds nothing to free. */
int  cotangent_init(Cotangent *C, const Disk *d);
void cotangent_free(Cotangent *C);

/* cotangent_init in two steps: first the graph, from which an elimination order can be computed;
 * then c. */
int  cotangent_graph(Cotangent *C, const Disk *d);
void cotangent_values(Cotangent *C, const Disk *d);

/* The stiffness matrix of quadratic elements on a mesh.  Its unknowns are the values at the
 * vertices and, after them, at the midpoints of the edges.  It equals (4 C_fine - C_coarse)/3:
 * C_coarse is the cotangent matrix of the mesh, with 0 in the rows and columns of midpoints, and
 * C_fine that of the mesh with every triangle split into four at the midpoints.  fine: in C_fine,
 * out the matrix.  Returns 0, or COTANGENT_ENOMEM with fine unchanged. */
int cotangent_quadratic(Cotangent *fine, const Cotangent *coarse);

/* <u, C u> and <v, C v>, summed over triangles.  Returns 0 or COTANGENT_ENOMEM. */
int cotangent_energy(const Mesh *m, const double *u, const double *v, double *Eu, double *Ev);

#endif
