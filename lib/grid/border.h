/* border.h - the boundary curve of a gridded surface: its outermost nodes, counterclockwise
 * from node (0,0), and places between them.
 *
 * A place on the curve is a number r, 0 <= r < 4: the number of a side (0: bottom, v = 0;
 * 1: right, u = 1; 2: top, v = T; 3: left, u = 0) plus the fraction of that side, in u or v, that
 * comes before the place.  Places 0 1 2 3 are the corners (0,0) (1,0) (1,T) (0,T).  r does not
 * depend on the numbers of nodes, nor on T.
 */
#ifndef BORDER_H
#define BORDER_H

enum {
	BORDER_ENOMEM  = -1,
	BORDER_ELENGTH = -2             /* the length of the curve is 0 or not finite */
};

typedef struct Border {
	int     nu, nv;         /* of the grid, each >= 2 */
	int     n;              /* nodes of the curve, 2(nu-1) + 2(nv-1) */
	double *x;              /* [n][3] positions */
	double *s;              /* [n+1] arc length from node 0, s[n] the total */
} Border;

/* Allocates x and s; the caller fills x.  Returns 0, or BORDER_ENOMEM with nothing to free. */
int  border_init(Border *b, int nu, int nv);
void border_free(Border *b);

/* Computes s from x.  Returns 0 or BORDER_ELENGTH. */
int border_measure(Border *b);

/* Convert node k of the curve to the node (i,j) of the grid, and (i,j) on the border to k. */
void border_node(int nu, int nv, int k, int *i, int *j);
int  border_index(int nu, int nv, int i, int j);

/* The place of node k, 0 <= k < n; for k = n, which is node 0 again, it is 4. */
double border_place(const Border *b, int k);

/* The edge k, from node k to node k+1 mod n, that contains place r; *w is the fraction
 * of the edge before r. */
int border_edge(const Border *b, double r, double *w);

/* Position, and arc length from node 0, at place r. */
void   border_at(const Border *b, double r, double x[3]);
double border_arc(const Border *b, double r);

/* The place of the point of the curve that is nearest to x; *d is the distance of x from it. */
double border_nearest(const Border *b, const double x[3], double *d);

#endif
