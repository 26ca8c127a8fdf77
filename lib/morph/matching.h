/* matching.h - corresponding points of two borders, by landmarks and by arc length between
 * them, equations (33)-(34), and the interpolated border.
 *
 * Landmark i is at place p_i of border a and at place q_i of border b, (33).  Between landmarks,
 * the point of a at the fraction f of the arc length from p_i to p_(i+1) corresponds to the point
 * of b at the fraction f of the arc length from q_i to q_(i+1), (34).  The last landmark is
 * followed by the first.
 *
 * A point of the interpolated border moves in space along a straight line, from a point of a to
 * the corresponding point of b, (20).  Its place on the border of the rectangle changes linearly,
 * too, from r_a to r_b:
 *
 *   x(t) = (1-t) x_a + t x_b     at place     r(t) = (1-t) r_a + t r_b
 *
 * So the interpolated border equals a at t = 0 and b at t = 1, node by node.  This is necessary
 * because lambda and H are interpolated at equal (u,v).  (In the paper the place remains r_a; then
 * the border at t = 1 would not fit the lambda of b.)
 */
#ifndef MATCHING_H
#define MATCHING_H

#include "../grid/border.h"

enum {
	MATCHING_ENOMEM  = -1,
	MATCHING_ELENGTH = -2           /* zero length between two landmarks */
};

/* Pairs of corresponding points, once round: every node and landmark of either border, with its
 * corresponding point on the other.  The last pair repeats the first. */
typedef struct Matching {
	int     n;
	double *r[2];           /* [n] places, not decreasing; r[.][n-1] = r[.][0] + 4 */
	double *x[2];           /* [n][3] positions */
} Matching;

/* Checks that n places are in counterclockwise order and go less than once round.  Returns the
 * index of the first place that breaks the order, or n. */
int matching_order(int n, const double *place);

/* Finds the pairs for n landmarks.
 *
 * p, q  in   [n] places of the landmarks on a and on b, counterclockwise, n >= 1
 * at    out  with MATCHING_ELENGTH: the first of the two landmarks
 *
 * Returns 0, or a negative code with nothing to free. */
int  matching_init(Matching *m, const Border *a, const Border *b, int n, const double *p,
	const double *q, int *at);

/* The matching in which equal places correspond; a and b must have the same number of nodes.
 * Returns 0 or MATCHING_ENOMEM. */
int  matching_conformal(Matching *m, const Border *a, const Border *b);
void matching_free(Matching *m);

/* Sets w, [m->n], to a weight for each pair, by arc length: half the length of the edges at a point
 * divided by the length of its curve, summed over the two points of the pair. */
void matching_weights(const Matching *m, double *w);

/* Sets x to the point at place r, 0 <= r < 4, of the interpolated border at parameter t. */
void matching_at(const Matching *m, double t, double r, double x[3]);

#endif
