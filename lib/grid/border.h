/* border.h - the boundary curve of a gridded surface: its outermost nodes, counterclockwise,
 * on the rectangle from node (0,0), and places between them.
 *
 * On the rectangle a place on the curve is a number r, 0 <= r < 4: the number of a side (0: bottom, v = 0;
 * 1: right, u = 1; 2: top, v = T; 3: left, u = 0) plus the fraction of that side, in u or v, that
 * comes before the place.  Places 0 1 2 3 are the corners (0,0) (1,0) (1,T) (0,T).  r does not
 * depend on the numbers of nodes, nor on T.  On the sock, whose boundary is one side, r is four times the share
 * of the period that comes before the place, from node (nu-1,nv-1) on, against the direction of u.
 */
#ifndef BORDER_H
#define BORDER_H

#include "../base/chart.h"

enum {
	BORDER_ENOMEM  = -1,
	BORDER_ELENGTH = -2             /* the length of the curve is 0 or not finite */
};

typedef struct Border {
	Chart   g;              /* of the grid: a rectangle or a sock, nu, nv >= 2 */
	int     n;              /* nodes of the curve: 2(nu-1) + 2(nv-1), on the sock nu */
	double *x;              /* [n][3] positions */
	double *s;              /* [n+1] arc length from node 0, s[n] the total */
} Border;

/* Allocates x and s; the caller fills x.  Returns 0, or BORDER_ENOMEM with nothing to free. */
int  border_init(Border *b, Chart g);
void border_free(Border *b);

/* Computes s from x.  Returns 0 or BORDER_ELENGTH. */
int border_measure(Border *b);

/* The number of nodes of the curve of a grid, and of node (i,j) on it; -1 if that is not on it. */
int  border_count(Chart g);
int  border_number(Chart g, int i, int j);

/* Convert node k of the curve of a rectangle to the node (i,j) of the grid, and (i,j) on the border to
 * k. */
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
