/* border.h - the boundary curve of a gridded surface: its outermost nodes, counterclockwise
 * from node (0,0), and places between them.
 *
 * A place r, 0 <= r < 4, is the number of a side (0 bottom v = 0, 1 right u = 1, 2 top v = T,
 * 3 left u = 0) plus the share of that side before the place.  Places 0 1 2 3 are the corners
 * (0,0) (1,0) (1,T) (0,T).  Equal places are equal conformal positions, for any numbers of nodes
 * and any T.
 */
#ifndef BORDER_H
#define BORDER_H

enum {
	BORDER_ENOMEM  = -1,
	BORDER_ELENGTH = -2             /* the curve has no length, or it is not finite */
};

typedef struct Border {
	int     nu, nv;         /* of the grid, each >= 2 */
	int     n;              /* nodes of the curve, 2(nu-1) + 2(nv-1) */
	double *x;              /* [n][3] positions */
	double *s;              /* [n+1] arc length from node 0, s[n] the total */
} Border;

/* Allocates x and s.  Returns 0, or BORDER_ENOMEM with nothing to free. */
int  border_init(Border *b, int nu, int nv);
void border_free(Border *b);

/* Computes s from x.  Returns 0 or BORDER_ELENGTH. */
int border_measure(Border *b);

/* Node k of the curve as node (i,j) of the grid, and back; (i,j) lies on the border. */
void border_node(int nu, int nv, int k, int *i, int *j);
int  border_index(int nu, int nv, int i, int j);

/* The place of node k, 0 <= k <= n; that of n is 4. */
double border_place(const Border *b, int k);

/* The edge k, from node k to node k+1 mod n, that contains place r; *w: its share before r. */
int border_edge(const Border *b, double r, double *w);

/* Position and arc length at place r. */
void   border_at(const Border *b, double r, double x[3]);
double border_arc(const Border *b, double r);

/* The place of the curve nearest to x; *d is its distance. */
double border_nearest(const Border *b, const double x[3], double *d);

#endif
