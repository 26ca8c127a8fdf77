/* matching.h - corresponding points of two borders, by landmarks and by arc length between
 * them, equations (33)-(34), and the border between the two.
 *
 * Landmark i is place p_i of border a and q_i of border b, (33).  The point at the share f of
 * the arc length from p_i to p_(i+1) corresponds to the point of b at the share f of the arc
 * length from q_i to q_(i+1), (34).  After the last landmark comes the first.
 *
 * A pair of corresponding points moves in space on a straight line, (20).  Its place moves
 * linearly, too, from r_a on the border of a's rectangle to r_b on that of b's:
 *
 *   x(t) = (1-t) x_a + t x_b     at place     r(t) = (1-t) r_a + t r_b
 *
 * So the border at t = 0 is a's, node by node, and at t = 1 b's.  lambda and H, which are
 * blended at equal conformal positions, require that.  (The paper leaves the place at r_a; then
 * the border would not fit b's lambda at t = 1.)
 */
#ifndef MATCHING_H
#define MATCHING_H

#include "../grid/border.h"

enum {
	MATCHING_ENOMEM  = -1,
	MATCHING_ELENGTH = -2           /* the curve has no length between two landmarks */
};

/* The vertices of both borders and their corresponding points, in pairs, once round; the last pair
 * repeats the first. */
typedef struct Matching {
	int     n;
	double *r[2];           /* [n] places, not decreasing; r[.][n-1] = r[.][0] + 4 */
	double *x[2];           /* [n][3] positions */
} Matching;

/* Checks that n places are in counterclockwise order, less than once round.  Returns the index of the
 * first that is not, or n. */
int matching_order(int n, const double *place);

/* p, q  in   [n] places in counterclockwise order, n >= 1
 * at    out  with MATCHING_ELENGTH: the first of the two landmarks
 *
 * Returns 0, or a negative code with nothing to free. */
int  matching_init(Matching *m, const Border *a, const Border *b, int n, const double *p,
	const double *q, int *at);

/* Equal places correspond; a and b must have equally many nodes.  Returns 0 or MATCHING_ENOMEM. */
int  matching_conformal(Matching *m, const Border *a, const Border *b);
void matching_free(Matching *m);

/* Sets w[n]: half the length of the edges at each vertex, as a share of the length of the curve,
 * summed over both curves. */
void matching_weights(const Matching *m, double *w);

/* The point at place r, 0 <= r < 4, of the interpolated border at t. */
void matching_at(const Matching *m, double t, double r, double x[3]);

#endif
