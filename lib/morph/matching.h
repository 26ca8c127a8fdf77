/* matching.h - which point of one border corresponds to which of another, by landmarks with
 * arc length between them, equations (33)-(34), and the border between the two.
 *
 * Landmark i is place p_i of border a and q_i of border b.  Between p_i and p_(i+1) a point
 * that has the share f of the arc length behind it corresponds to the point of b that has
 * the share f of the arc length between q_i and q_(i+1) behind it, (34); the last goes on to the
 * first.
 *
 * A pair of points that correspond moves in space on a straight line, (20), and from its
 * place r_a on the border of a's rectangle to its place r_b on that of b's evenly, too:
 *
 *   x(t) = (1-t) x_a + t x_b     at place     r(t) = (1-t) r_a + t r_b
 *
 * So the border at t = 0 is a's, node by node, and at t = 1 b's, as lambda and H, which stay
 * at equal conformal position, demand.  (Left at r_a, as the paper has it, the border would not
 * fit b's lambda at t = 1.)
 */
#ifndef MATCHING_H
#define MATCHING_H

#include "../grid/border.h"

enum {
	MATCHING_ENOMEM  = -1,
	MATCHING_ELENGTH = -2           /* the curve has no length between two landmarks */
};

/* All vertices of both borders, in pairs, once round and the first again. */
typedef struct Matching {
	int     n;
	double *r[2];           /* [n] places, never going down; r[.][n-1] = r[.][0] + 4 */
	double *x[2];           /* [n][3] positions */
} Matching;

/* The first of n places, in the order given, that does not go on counterclockwise, or that
 * comes round to the first again; n if there is none. */
int matching_order(int n, const double *place);

/* p, q  in   [n] places in such an order, n >= 1
 * at    out  with MATCHING_ELENGTH: the landmark before
 *
 * Returns 0, or a negative code; m then holds nothing to free. */
int  matching_init(Matching *m, const Border *a, const Border *b, int n, const double *p,
	const double *q, int *at);

/* Equal places correspond; a and b have equally many nodes.  Returns 0 or MATCHING_ENOMEM. */
int  matching_conformal(Matching *m, const Border *a, const Border *b);
void matching_free(Matching *m);

/* Half the edges at each vertex, of both curves, each over its length: weights w[n]. */
void matching_weights(const Matching *m, double *w);

/* The point of the border at t that is at place r, 0 <= r < 4. */
void matching_at(const Matching *m, double t, double r, double x[3]);

#endif
